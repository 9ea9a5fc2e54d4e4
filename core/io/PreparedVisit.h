// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/PreparedVolume.h"

#include <cstdint>
#include <memory>
#include <string>
#include <type_traits>
#include <vector>

namespace brickwall {

/// Shows all that a prepared volume consists of to an archive, which reads or writes it: one order for both. It has
/// value(T&), text(std::string&), array(std::vector<T>&), and resize(vector&), which writes a length or follows one.
template <class Archive>
class PreparedVisit
{
public:
    explicit PreparedVisit(Archive& archive) : archive_(archive) {}

    void visit(PreparedVolume& volume)
    {
        visit(volume.model);
        visit(volume.regions);
        visitFields(volume.fields);
        archive_.resize(volume.pyramid);
        for (PyramidMember& member : volume.pyramid) {
            archive_.value(member.level);
            archive_.value(member.cells);
            visit(member.regions);
            visitFields(member.fields);
        }
    }

private:
    void visit(Model& model)
    {
        archive_.text(model.name);
        archive_.array(model.bricks);
        archive_.value(model.worldFromVoxel);
        archive_.value(model.cellCount);
        archive_.resize(model.fields);
        for (Field& field : model.fields) {
            archive_.text(field.name);
            archive_.text(field.unit);
            archive_.value(field.range);
            archive_.value(field.preferredRange);
        }
        archive_.resize(model.meshes);
        for (TriangleMesh& mesh : model.meshes) {
            archive_.array(mesh.vertices);
            archive_.array(mesh.triangles);
            archive_.value(mesh.color);
        }
        archive_.resize(model.notes);
        for (std::string& note : model.notes)
            archive_.text(note);
    }

    void visit(std::shared_ptr<const RegionTree>& shared)
    {
        RegionTree& tree = changeable(shared);
        archive_.value(tree.bounds);
        archive_.array(tree.nodes);
        archive_.array(tree.regions);
        archive_.array(tree.brickLists);
        archive_.array(tree.bricks);
        archive_.value(tree.paddedCellCount);
        archive_.value(tree.depth);
    }

    void visitFields(std::vector<std::shared_ptr<const PaddedField>>& fields)
    {
        archive_.resize(fields);
        for (auto& shared : fields) {
            PaddedField& field = changeable(shared);
            archive_.array(field.values);
            archive_.array(field.regionRanges);
            archive_.array(field.regionSlopes);
            archive_.array(field.regionLogSlopes);
            archive_.value(field.range);
        }
    }

    /// An archive that writes changes nothing; one that reads fills what it finds empty.
    template <class T>
    static T& changeable(std::shared_ptr<const T>& shared)
    {
        if (!shared)
            shared = std::make_shared<T>();
        return const_cast<T&>(*shared);
    }

    Archive& archive_;
};

} // namespace brickwall
