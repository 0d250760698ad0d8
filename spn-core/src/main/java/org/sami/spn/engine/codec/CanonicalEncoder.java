package org.sami.spn.engine.codec;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import org.sami.spn.engine.net.CompiledProject;
import org.sami.spn.engine.state.MissionState;
import org.sami.spn.engine.state.NetState;
import org.sami.spn.engine.state.OpenDecision;
import org.sami.spn.engine.state.RunningTimer;

/**
 * Writes what a state means and nothing of how it came about: ids are renumbered, times are counted from now, counters and the
 * clock are left out. What the rules read in order is written in order: tokens and visits of a place, pending occurrences of an
 * input event, timers, robots, the missions of one root. Root missions are independent of one another, and written in an order
 * of their contents, unless the project has global variables: then the order in which they hear of news decides whose write is
 * the last.
 */
public final class CanonicalEncoder {
    private final NetState state;

    public CanonicalEncoder(NetState state) {
        this.state = state;
    }

    /** The bytes, equal for two states of one engine that mean the same. */
    public byte[] write() {
        List<List<MissionState>> trees = trees();
        List<MissionState> written = trees.size() == 1
                ? trees.get(0)
                : trees.stream().flatMap(List::stream).toList();
        CanonicalNumbers numbers = new CanonicalNumbers(state.missions, written);
        ProtocolEncoder out = ProtocolEncoder.canonical(numbers::mission);
        trees.forEach(tree -> tree(tree, numbers, out));
        out.text(state.newest().sha256);
        out.texts(state.proxies());
        out.values(state.globals.all());
        out.values(state.memory.all());
        questions(out);
        return out.bytes();
    }

    /** Missions by root, each root's in the order in which they started. */
    private List<List<MissionState>> trees() {
        if (state.missions.size() == 1) {
            return List.of(List.copyOf(state.missions.values()));
        }
        Map<MissionState, List<MissionState>> byRoot = new HashMap<>();
        List<List<MissionState>> trees = new ArrayList<>();
        for (MissionState m : state.missions.values()) {
            byRoot.computeIfAbsent(m.root, root -> {
                        List<MissionState> tree = new ArrayList<>();
                        trees.add(tree);
                        return tree;
                    })
                    .add(m);
        }
        if (trees.size() > 1 && nothingDeclaresGlobals()) {
            Map<List<MissionState>, byte[]> contents = new HashMap<>();
            trees.forEach(tree -> contents.put(tree, alone(tree)));
            trees.sort((a, b) -> Arrays.compareUnsigned(contents.get(a), contents.get(b)));
        }
        return trees;
    }

    private boolean nothingDeclaresGlobals() {
        return state.newest().globals.isEmpty() && state.running().stream().allMatch(p -> p.globals.isEmpty());
    }

    private byte[] alone(List<MissionState> tree) {
        CanonicalNumbers numbers = new CanonicalNumbers(state.missions, tree);
        ProtocolEncoder out = ProtocolEncoder.canonical(numbers::mission);
        tree(tree, numbers, out);
        return out.bytes();
    }

    private void tree(List<MissionState> tree, CanonicalNumbers numbers, ProtocolEncoder out) {
        out.integer(tree.size());
        CompiledProject project = tree.get(0).plan.project;
        boolean isNewest = project.sha256.equals(state.newest().sha256);
        out.flag(isNewest);
        if (!isNewest) {
            out.text(project.sha256);
        }
        CanonicalMission mission = new CanonicalMission(state, numbers, out);
        tree.forEach(mission::write);
        List<RunningTimer> timers = state.timers.isEmpty()
                ? List.of()
                : state.timers.stream().filter(t -> rootOf(t) == tree.get(0)).toList();
        out.integer(timers.size());
        for (RunningTimer t : timers) {
            out.number(t.due() - state.now);
            out.flag(t.isDeadline());
            out.number(numbers.activation(state.activationOf(t).activation.id()));
            out.token(t.token());
        }
    }

    private MissionState rootOf(RunningTimer t) {
        return state.activationOf(t).mission().root;
    }

    /** What the domain asks; there is one question of a kind about each. */
    private void questions(ProtocolEncoder out) {
        if (state.decisions.isEmpty()) {
            out.integer(0);
            return;
        }
        List<OpenDecision> asked = state.decisions.values().stream()
                .filter(d -> d.purpose == OpenDecision.Purpose.DOMAIN)
                .sorted(Comparator.comparing((OpenDecision d) -> d.decision.type())
                        .thenComparing(d -> d.subject))
                .toList();
        out.integer(asked.size());
        for (OpenDecision d : asked) {
            out.text(d.subject);
            out.content(d.decision);
        }
    }
}
