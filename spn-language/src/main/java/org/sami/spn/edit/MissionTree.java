package org.sami.spn.edit;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.sami.spn.model.ImportOrigin;
import org.sami.spn.model.MissionTreeNode;

/** Changes of the mission tree. */
final class MissionTree {
    private MissionTree() {}

    static MissionTreeNode leaf(String plan) {
        return new MissionTreeNode("", Optional.of(plan), List.of());
    }

    /** Without a plan; its children take its place. */
    static List<MissionTreeNode> without(List<MissionTreeNode> nodes, String plan) {
        List<MissionTreeNode> kept = new ArrayList<>();
        for (MissionTreeNode node : nodes) {
            List<MissionTreeNode> children = without(node.children(), plan);
            if (shows(node, plan)) {
                kept.addAll(children);
            } else {
                kept.add(node.withChildren(children));
            }
        }
        return kept;
    }

    static List<MissionTreeNode> renamed(List<MissionTreeNode> nodes, String from, String to) {
        return nodes.stream()
                .map(n -> n.withChildren(renamed(n.children(), from, to))
                        .withPlan(n.plan().map(p -> p.equals(from) ? to : p)))
                .toList();
    }

    static ImportOrigin renamed(ImportOrigin origin, String from, String to) {
        return new ImportOrigin(
                origin.file(),
                Parts.replaced(
                        origin.remarks(),
                        r -> r.plan().equals(from),
                        r -> new ImportOrigin.Remark(r.code(), to, r.elements(), r.message())));
    }

    /** With a leaf for the copy of a plan behind each node that shows it. */
    static List<MissionTreeNode> cloned(List<MissionTreeNode> nodes, String plan, String copy) {
        List<MissionTreeNode> grown = new ArrayList<>();
        for (MissionTreeNode node : nodes) {
            grown.add(node.withChildren(cloned(node.children(), plan, copy)));
            if (shows(node, plan)) {
                grown.add(leaf(copy));
            }
        }
        return grown;
    }

    private static boolean shows(MissionTreeNode node, String plan) {
        return node.plan().equals(Optional.of(plan));
    }

    static List<MissionTreeNode> moved(List<MissionTreeNode> roots, List<Integer> from, List<Integer> parent, int index)
            throws EditRefusedException {
        MissionTreeNode node = at(roots, from);
        if (!parent.isEmpty()) {
            at(roots, parent);
        }
        if (parent.size() >= from.size() && parent.subList(0, from.size()).equals(from)) {
            throw new EditRefusedException("A node of the mission tree does not go below itself");
        }
        return inserted(removed(roots, from), after(parent, from), index, node);
    }

    private static MissionTreeNode at(List<MissionTreeNode> roots, List<Integer> path) throws EditRefusedException {
        List<MissionTreeNode> nodes = roots;
        MissionTreeNode node = null;
        for (int i : path) {
            if (i < 0 || i >= nodes.size()) {
                node = null;
                break;
            }
            node = nodes.get(i);
            nodes = node.children();
        }
        return Parts.found(Optional.ofNullable(node), "The mission tree has no node at " + path);
    }

    /** Where a path leads when the node of another has been taken out. */
    private static List<Integer> after(List<Integer> path, List<Integer> taken) {
        int depth = taken.size() - 1;
        boolean later = path.size() > depth
                && path.subList(0, depth).equals(taken.subList(0, depth))
                && path.get(depth) > taken.get(depth);
        List<Integer> moved = new ArrayList<>(path);
        if (later) {
            moved.set(depth, path.get(depth) - 1);
        }
        return moved;
    }

    private static List<MissionTreeNode> removed(List<MissionTreeNode> nodes, List<Integer> path) {
        List<MissionTreeNode> changed = new ArrayList<>(nodes);
        int first = path.get(0);
        if (path.size() == 1) {
            changed.remove(first);
        } else {
            MissionTreeNode node = nodes.get(first);
            changed.set(first, node.withChildren(removed(node.children(), path.subList(1, path.size()))));
        }
        return changed;
    }

    private static List<MissionTreeNode> inserted(
            List<MissionTreeNode> nodes, List<Integer> parent, int index, MissionTreeNode added) {
        List<MissionTreeNode> changed = new ArrayList<>(nodes);
        if (parent.isEmpty()) {
            changed.add(Math.max(0, Math.min(index, changed.size())), added);
        } else {
            MissionTreeNode node = nodes.get(parent.get(0));
            changed.set(
                    parent.get(0),
                    node.withChildren(inserted(node.children(), parent.subList(1, parent.size()), index, added)));
        }
        return changed;
    }
}
