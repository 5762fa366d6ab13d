// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Divides constraints into clusters and passes.
#include "cloth/build/clusters.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>

namespace meniscus::cloth {

namespace {

constexpr uint32_t none = 0xffffffff;

/// A constraint of any kind.
struct Any {
  ConstraintKind kind;
  uint32_t item, colour;
  std::array<uint32_t, 4> vertices;
  uint32_t vertex_count;
  uint32_t cluster = none;

  std::span<const uint32_t> touched() const { return {vertices.data(), vertex_count}; }
};

template <class T, class Vertices>
void list(std::vector<Any>& all, ConstraintKind kind, const Coloured<T>& from, uint32_t vertex_count,
          const Vertices& vertices) {
  for (uint32_t c = 0; c < from.colours(); ++c) {
    for (uint32_t k = from.colour_starts[c]; k < from.colour_starts[c + 1]; ++k)
      all.push_back({kind, k, c, vertices(from.items[k]), vertex_count});
  }
}

bool have_few_colours(const ClothConstraints& c) {
  return c.strains.items.empty() && c.edges.colours() <= 2;
}

/// Lists the constraints that clusters are built from.
std::vector<Any> list_all(const ClothConstraints& c) {
  std::vector<Any> all;
  const auto four = [](const auto& h) { return std::array{h.a, h.b, h.c, h.d}; };
  list(all, ConstraintKind::hinge, c.hinges, 4, four);
  list(all, ConstraintKind::strain, c.strains, 3, [](const auto& s) {
    return std::array{s.a, s.b, s.c, none};
  });
  if (!have_few_colours(c))
    list(all, ConstraintKind::edge, c.edges, 2, [](const auto& e) {
      return std::array{e.a, e.b, none, none};
    });
  return all;
}

/// Halves a set of vertices across its longest side until its parts are small enough.
class Bisection {
 public:
  Bisection(std::span<const Vec3> rest, std::vector<uint32_t>& part) : rest_(rest), part_(part) {}

  uint32_t split(std::span<uint32_t> vertices) {
    if (vertices.size() <= Cluster::most_vertices) {
      for (uint32_t v : vertices) part_[v] = parts_;
      return ++parts_;
    }
    Vec3 lower = rest_[vertices[0]], upper = lower;
    for (uint32_t v : vertices) {
      lower = min(lower, rest_[v]);
      upper = max(upper, rest_[v]);
    }
    const Vec3 size = upper - lower;
    float Vec3::*axis = size.x >= size.y && size.x >= size.z ? &Vec3::x
                        : size.y >= size.z                   ? &Vec3::y
                                                             : &Vec3::z;
    const auto middle = vertices.begin() + static_cast<std::ptrdiff_t>(vertices.size() / 2);
    std::nth_element(vertices.begin(), middle, vertices.end(), [&](uint32_t a, uint32_t b) {
      return std::pair(rest_[a].*axis, a) < std::pair(rest_[b].*axis, b);
    });
    split({vertices.begin(), middle});
    return split({middle, vertices.end()});
  }

 private:
  std::span<const Vec3> rest_;
  std::vector<uint32_t>& part_;
  uint32_t parts_ = 0;
};

/// Joins successive parts that are small enough together.
uint32_t put_together(std::span<const uint32_t> size, std::vector<uint32_t>& part) {
  std::vector<uint32_t> number;
  uint32_t parts = 0, sum = 0;
  for (uint32_t s : size) {
    if (sum + s > Cluster::most_vertices) {
      ++parts;
      sum = 0;
    }
    sum += s;
    number.push_back(parts);
  }
  for (uint32_t& p : part) {
    if (p != none) p = number[p];
  }
  return parts + 1;
}

/// Grows parts over the constraints that remain. These are the bands between the parts of the last pass, and
/// are cut at other places.
uint32_t grow_parts(std::span<const Any> all, std::span<const uint32_t> left, std::vector<uint32_t>& part) {
  std::vector<uint32_t> start(part.size() + 1), at;
  for (uint32_t k : left) {
    for (uint32_t v : all[k].touched()) ++start[v + 1];
  }
  std::partial_sum(start.begin(), start.end(), start.begin());
  at.resize(start.back());
  std::vector<uint32_t> next(start.begin(), start.end() - 1);
  for (uint32_t k : left) {
    for (uint32_t v : all[k].touched()) at[next[v]++] = k;
  }
  std::vector<uint32_t> front, size;
  for (uint32_t seed = 0; seed < part.size(); ++seed) {
    if (part[seed] != none || start[seed] == start[seed + 1]) continue;
    const auto parts = static_cast<uint32_t>(size.size());
    front.assign(1, seed);
    part[seed] = parts;
    for (size_t k = 0; k < front.size(); ++k) {
      for (uint32_t n = start[front[k]]; n < start[front[k] + 1]; ++n) {
        for (uint32_t v : all[at[n]].touched()) {
          if (part[v] != none || front.size() >= Cluster::most_vertices) continue;
          part[v] = parts;
          front.push_back(v);
        }
      }
    }
    size.push_back(static_cast<uint32_t>(front.size()));
  }
  return put_together(size, part);
}

template <class T>
void take(const Any& c, ConstraintKind kind, const std::vector<T>& from, std::vector<T>& to) {
  if (c.kind == kind) to.push_back(from[c.item]);
}

/// Assigns the given constraints to clusters, pass by pass.
class Clustering {
 public:
  Clustering(std::vector<Any>& all, std::span<const Vec3> rest) : all_(all), rest_(rest) {}

  void add(std::vector<uint32_t> left, std::vector<uint32_t>& pass_starts) {
    for (bool first = true; !left.empty(); first = false) {
      std::vector<uint32_t> part(rest_.size(), none);
      const uint32_t parts = first ? halve(part) : grow_parts(all_, left, part);
      std::vector<uint32_t> number(parts, none);  // a part with a constraint becomes a cluster
      std::erase_if(left, [&](uint32_t k) {
        const std::span<const uint32_t> v = all_[k].touched();
        if (std::any_of(v.begin(), v.end(), [&](uint32_t u) { return part[u] != part[v[0]]; })) return false;
        uint32_t& cluster = number[part[v[0]]];
        if (cluster == none) cluster = clusters_++;
        all_[k].cluster = cluster;
        return true;
      });
      pass_starts.push_back(clusters_);
    }
  }

 private:
  uint32_t halve(std::vector<uint32_t>& part) const {
    std::vector<uint32_t> vertices(rest_.size());
    std::iota(vertices.begin(), vertices.end(), 0u);
    return Bisection(rest_, part).split(vertices);
  }

  std::vector<Any>& all_;
  std::span<const Vec3> rest_;
  uint32_t clusters_ = 0;
};

/// Calls visit(vertex) for each vertex of each constraint of a cluster.
template <class Visit>
void for_each_vertex(Clusters& all, const Cluster& cluster, const Visit& visit) {
  const auto four = [&](auto& h) {
    for (uint32_t* v : {&h.a, &h.b, &h.c, &h.d}) visit(*v);
  };
  for (uint32_t b = cluster.first_batch; b < cluster.end_batch; ++b) {
    const Batch& batch = all.batches[b];
    for (uint32_t k = batch.first; k < batch.first + batch.count; ++k) {
      switch (batch.kind) {
        case ConstraintKind::hinge:
          four(all.hinges[k]);
          break;
        case ConstraintKind::strain:
          for (uint32_t* v : {&all.strains[k].a, &all.strains[k].b, &all.strains[k].c}) visit(*v);
          break;
        case ConstraintKind::edge:
          for (uint32_t* v : {&all.edges[k].a, &all.edges[k].b}) visit(*v);
          break;
      }
    }
  }
}

void list_vertices(Clusters& all) {
  for (Cluster& cluster : all.clusters) {
    std::vector<uint32_t> touched;
    for_each_vertex(all, cluster, [&](uint32_t& v) { touched.push_back(v); });
    std::sort(touched.begin(), touched.end());
    touched.erase(std::unique(touched.begin(), touched.end()), touched.end());
    cluster.first_vertex = static_cast<uint32_t>(all.vertices.size());
    all.vertices.insert(all.vertices.end(), touched.begin(), touched.end());
    cluster.end_vertex = static_cast<uint32_t>(all.vertices.size());
  }
}

void note_items(Clusters& all) {
  for (Cluster& cluster : all.clusters) {
    for (uint32_t b = cluster.first_batch; b < cluster.end_batch; ++b) {
      const Batch& batch = all.batches[b];
      if (batch.kind != ConstraintKind::edge) continue;
      if (cluster.end_item == 0) cluster.first_item = batch.first;
      cluster.end_item = batch.first + batch.count;
    }
  }
}

}  // namespace

Clusters build_clusters(const ClothConstraints& constraints, std::span<const Vec3> rest) {
  std::vector<Any> all = list_all(constraints);
  Clusters out;
  // Bending is solved before stretch, since the lengths are to hold at the end.
  std::vector<uint32_t> bending, stretch;
  for (uint32_t k = 0; k < all.size(); ++k)
    (all[k].kind < ConstraintKind::strain ? bending : stretch).push_back(k);
  Clustering clustering(all, rest);
  clustering.add(std::move(bending), out.pass_starts);
  out.bending_passes = static_cast<uint32_t>(out.pass_starts.size() - 1);
  clustering.add(std::move(stretch), out.pass_starts);
  std::stable_sort(all.begin(), all.end(), [](const Any& a, const Any& b) {
    return std::tuple(a.cluster, a.kind, a.colour) < std::tuple(b.cluster, b.kind, b.colour);
  });
  std::array<uint32_t, 3> next{};  // next item of each kind
  const Any* before = nullptr;
  for (const Any& c : all) {
    const bool new_cluster = !before || before->cluster != c.cluster;
    if (new_cluster || before->kind != c.kind || before->colour != c.colour)
      out.batches.push_back({c.kind, next[static_cast<size_t>(c.kind)], 0});
    const auto end = static_cast<uint32_t>(out.batches.size());
    if (new_cluster) out.clusters.push_back({end - 1, end, 0, 0, 0, 0});
    out.clusters.back().end_batch = end;
    ++out.batches.back().count;
    ++next[static_cast<size_t>(c.kind)];
    take(c, ConstraintKind::hinge, constraints.hinges.items, out.hinges);
    take(c, ConstraintKind::strain, constraints.strains.items, out.strains);
    take(c, ConstraintKind::edge, constraints.edges.items, out.edges);
    before = &c;
  }
  if (have_few_colours(constraints)) {
    out.edges = constraints.edges.items;
    out.colour_starts = constraints.edges.colour_starts;
  }
  list_vertices(out);
  note_items(out);
  return out;
}

void number_locally(Clusters& clusters) {
  for (const Cluster& c : clusters.clusters) {
    const auto begin = clusters.vertices.begin() + c.first_vertex,
               end = clusters.vertices.begin() + c.end_vertex;
    for_each_vertex(clusters, c,
                    [&](uint32_t& v) { v = static_cast<uint32_t>(std::lower_bound(begin, end, v) - begin); });
  }
}

}  // namespace meniscus::cloth
