// SPDX-FileCopyrightText: 2026 The Meniscus authors
// SPDX-License-Identifier: MIT
//
// Small good mesh files of each format, to be damaged by tests.
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace meniscus::collision::mesh_files {

template <class T>
std::string bytes_of(T value) {
  std::string bytes(sizeof value, '\0');
  std::memcpy(bytes.data(), &value, sizeof value);
  return bytes;
}

inline constexpr float corners[4][3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
inline constexpr int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};

inline std::string ply_header(const std::string& format, const std::string& vertices = "4",
                              const std::string& face_count = "4") {
  std::string header;
  for (const std::string& part :
       {std::string("ply\nformat "), format, std::string(" 1.0\ncomment a tetrahedron\nelement vertex "),
        vertices, std::string("\nproperty float x\nproperty float y\nproperty float z\nelement face "),
        face_count, std::string("\nproperty list uchar int vertex_indices\nend_header\n")})
    header.append(part);
  return header;
}

/// The body of a binary PLY file, with the first index of its last face as given.
inline std::string ply_body(int32_t index = 1) {
  std::string body;
  for (const auto& corner : corners) {
    for (const float x : corner) body += bytes_of(x);
  }
  for (const auto& face : faces) {
    body += '\3';
    for (const int v : face) body += bytes_of(&face == &faces[3] && v == 1 ? index : int32_t{v});
  }
  return body;
}

inline std::string binary_ply() {
  return ply_header("binary_little_endian") + ply_body();
}

inline std::string ascii_ply() {
  return ply_header("ascii") + "0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 0 3 2\n3 1 2 3\n";
}

inline std::string binary_stl(uint32_t promised = 4) {
  std::string file(80, ' ');
  file += bytes_of(promised);
  for (const auto& face : faces) {
    file += std::string(12, '\0');
    for (const int v : face) {
      for (const float x : corners[v]) file += bytes_of(x);
    }
    file += std::string(2, '\0');
  }
  return file;
}

inline std::string ascii_stl() {
  std::string file = "solid tetrahedron\n";
  for (const auto& face : faces) {
    file += "facet normal 0 0 0\nouter loop\n";
    for (const int v : face) {
      file += "vertex";
      for (const float x : corners[v]) file += x > 0 ? " 1" : " 0";
      file += '\n';
    }
    file += "endloop\nendfacet\n";
  }
  return file + "endsolid tetrahedron\n";
}

inline std::string obj() {
  return "o tetrahedron\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nvt 0 0\nvn 0 0 1\n"
         "usemtl paint\nf 1/1/1 3/1/1 2/1/1\nf 1//1 2//1 4//1\nf 1 4 3\nf -3 -2 \\\n-1\n";
}

inline std::string gltf_json(const std::string& buffer) {
  return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],)"
         R"("meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],)"
         R"("accessors":[{"bufferView":0,"componentType":5126,"count":4,"type":"VEC3","min":[0,0,0],"max":[1,1,1]},)"
         R"({"bufferView":1,"componentType":5121,"count":12,"type":"SCALAR"}],)"
         R"("bufferViews":[{"buffer":0,"byteLength":48},{"buffer":0,"byteOffset":48,"byteLength":12}],)"
         R"("buffers":[{"byteLength":60)" +
         buffer + "}]}";
}

inline std::string gltf_bytes() {
  std::string body;
  for (const auto& corner : corners) {
    for (const float x : corner) body += bytes_of(x);
  }
  for (const auto& face : faces) {
    for (const int v : face) body += static_cast<char>(v);
  }
  return body;
}

inline std::string gltf() {
  constexpr const char* digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  const std::string body = gltf_bytes();  // 60 bytes: a multiple of three
  std::string text;
  for (std::size_t i = 0; i < body.size(); i += 3) {
    const auto byte = [&](std::size_t k) { return static_cast<unsigned char>(body[i + k]); };
    const unsigned three = byte(0) << 16 | byte(1) << 8 | byte(2);
    for (int shift = 18; shift >= 0; shift -= 6) text += digits[three >> shift & 63];
  }
  return gltf_json(R"(,"uri":"data:application/octet-stream;base64,)" + text + '"');
}

inline std::string glb() {
  std::string json = gltf_json("");
  json.append((4 - json.size() % 4) % 4, ' ');
  const std::string body = gltf_bytes();
  const auto size = static_cast<uint32_t>(12 + 8 + json.size() + 8 + body.size());
  return "glTF" + bytes_of(uint32_t{2}) + bytes_of(size) + bytes_of(static_cast<uint32_t>(json.size())) +
         "JSON" + json + bytes_of(static_cast<uint32_t>(body.size())) + std::string("BIN\0", 4) + body;
}

inline std::string chunk(uint16_t id, const std::string& body) {
  return bytes_of(id) + bytes_of(static_cast<uint32_t>(6 + body.size())) + body;
}

inline std::string three_ds() {
  std::string vertices = bytes_of(uint16_t{4}), triangles = bytes_of(uint16_t{4});
  for (const auto& corner : corners) {
    for (const float x : corner) vertices += bytes_of(x);
  }
  for (const auto& face : faces) {
    for (const int v : face) triangles += bytes_of(static_cast<uint16_t>(v));
    triangles += bytes_of(uint16_t{7});
  }
  const std::string object =
      std::string("tetra\0", 6) + chunk(0x4100, chunk(0x4110, vertices) + chunk(0x4120, triangles));
  return chunk(0x4D4D, chunk(0x3D3D, chunk(0x4000, object)));
}

inline std::string dae() {
  return R"(<?xml version="1.0"?>
<COLLADA xmlns="http://www.collada.org/2005/11/COLLADASchema" version="1.4.1">
<asset><unit name="meter" meter="1"/><up_axis>Y_UP</up_axis></asset>
<library_geometries><geometry id="g"><mesh>
<source id="p"><float_array id="pa" count="12">0 0 0 1 0 0 0 1 0 0 0 1</float_array>
<technique_common><accessor source="#pa" count="4" stride="3"><param name="X" type="float"/><param name="Y" type="float"/>
<param name="Z" type="float"/></accessor></technique_common></source>
<vertices id="v"><input semantic="POSITION" source="#p"/></vertices>
<triangles count="4"><input semantic="VERTEX" source="#v" offset="0"/><p>0 2 1 0 1 3 0 3 2 1 2 3</p></triangles>
</mesh></geometry></library_geometries>
<library_visual_scenes><visual_scene id="s"><node id="a"><instance_geometry url="#g"/></node></visual_scene></library_visual_scenes>
<scene><instance_visual_scene url="#s"/></scene></COLLADA>)";
}

/// `unit`: the length of its unit, cm.
inline std::string fbx(const std::string& unit = "100") {
  return R"(; FBX 7.4.0 project file
FBXHeaderExtension:  {
  FBXHeaderVersion: 1003
  FBXVersion: 7400
}
GlobalSettings:  {
  Version: 1000
  Properties70:  {
    P: "UnitScaleFactor", "double", "Number", "",)" +
         unit + R"(
  }
}
Objects:  {
  Geometry: 1000, "Geometry::g", "Mesh" {
    Vertices: *12 {
      a: 0,0,0,1,0,0,0,1,0,0,0,1
    }
    PolygonVertexIndex: *12 {
      a: 0,2,-2,0,1,-4,0,3,-3,1,2,-4
    }
    GeometryVersion: 124
  }
  Model: 2000, "Model::m", "Mesh" {
    Version: 232
  }
}
Connections:  {
  C: "OO",1000,2000
  C: "OO",2000,0
}
)";
}

struct GoodFile {
  const char* name;
  std::string bytes;
};
inline std::vector<GoodFile> good_files() {
  return {{"binary.ply", binary_ply()},
          {"ascii.ply", ascii_ply()},
          {"binary.stl", binary_stl()},
          {"ascii.stl", ascii_stl()},
          {"a.obj", obj()},
          {"a.gltf", gltf()},
          {"a.glb", glb()},
          {"a.3ds", three_ds()},
          {"a.dae", dae()},
          {"a.fbx", fbx()}};
}

}  // namespace meniscus::collision::mesh_files
