package org.sami.spn.reference;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.OptionalLong;
import java.util.Set;
import org.sami.spn.engine.Engine;
import org.sami.spn.engine.EngineState;
import org.sami.spn.engine.MissionView;
import org.sami.spn.model.Project;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Effect;
import org.sami.spn.protocol.FollowedMarking;
import org.sami.spn.protocol.Input;
import org.sami.spn.protocol.Token;
import org.sami.spn.vocabulary.Vocabulary;

/** The engine as a subject. Loaded a second time, next to a spoilt engine, by {@link SpoiltEngine}. */
public final class EngineSubject implements Subject {
    private final Engine engine;
    private final EngineState state;

    /** An engine where nothing runs. */
    public EngineSubject(Vocabulary vocabulary, Project project, int livelockLimit) {
        engine = new Engine(vocabulary, project, livelockLimit);
        state = engine.newState();
    }

    @Override
    public List<Effect> step(long nowMillis, Input input) {
        return engine.step(state, nowMillis, input);
    }

    @Override
    public Map<Long, Map<String, List<Token>>> markings() {
        Map<Long, Map<String, List<Token>>> markings = new LinkedHashMap<>();
        for (MissionView mission : engine.view(state).missions()) {
            Map<String, List<Token>> marking = new LinkedHashMap<>(mission.marking());
            marking.values().removeIf(List::isEmpty);
            markings.put(mission.id(), marking);
        }
        return markings;
    }

    @Override
    public Map<Long, Set<String>> visitedByNobody() {
        FollowedMarking told = retold();
        Map<Long, Set<String>> places = new LinkedHashMap<>();
        told.missions().forEach(mission -> places.put(mission, told.visitedByNobody(mission)));
        return places;
    }

    private FollowedMarking retold() {
        FollowedMarking told = new FollowedMarking();
        engine.view(state).markingAsEffects().forEach(told);
        return told;
    }

    @Override
    public Map<Long, String> statuses() {
        Map<Long, String> statuses = new LinkedHashMap<>();
        engine.view(state)
                .missions()
                .forEach(m -> statuses.put(m.id(), m.status().name()));
        return statuses;
    }

    @Override
    public Set<Long> openActivations() {
        Set<Long> open = new LinkedHashSet<>();
        engine.view(state).openActivations().stream().map(Activation::id).forEach(open::add);
        return open;
    }

    @Override
    public Set<Long> openDecisions() {
        Set<Long> open = new LinkedHashSet<>();
        engine.view(state).decisions().stream().map(Decision::id).forEach(open::add);
        return open;
    }

    @Override
    public OptionalLong nextDueMillis() {
        return engine.view(state).nextDueMillis();
    }
}
