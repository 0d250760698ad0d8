package org.sami.spn.statespace;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.sami.spn.finding.Advice;

/** Runs the plan once and asks of its states all that deep checks ask. */
final class EveryQuestion implements SpaceQuestion {
    private static final List<SpaceQuestion> PARTS = List.of(
            new StuckStates(),
            new LeftAtTheEnd(),
            new WaitsForNobody(),
            new TokensPileUp(),
            new NeverReached(),
            new StuckAfterDrop());

    static List<DeepCheck> withItsParts() {
        List<DeepCheck> all = new ArrayList<>(List.of(new EveryQuestion()));
        all.addAll(PARTS);
        return List.copyOf(all);
    }

    @Override
    public String id() {
        return "everything";
    }

    @Override
    public String title() {
        return "All deep checks";
    }

    @Override
    public String help() {
        return "Runs the plan once and looks for all that the other searches look for.";
    }

    @Override
    public List<Advice> advice() {
        return PARTS.stream().flatMap(part -> part.advice().stream()).toList();
    }

    @Override
    public boolean dropsRobots() {
        return true;
    }

    @Override
    public List<DeepFinding> findings(Exploration found, DeepRequest request) {
        return PARTS.stream()
                .flatMap(part -> part.findings(found, request).stream())
                .toList();
    }

    @Override
    public String result(Exploration found, DeepRequest request) {
        return PARTS.stream().map(part -> part.result(found, request)).collect(Collectors.joining("; "));
    }
}
