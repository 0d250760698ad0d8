package org.sami.crw.sim.run.incident;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.sami.crw.decision.DomainQuestion;
import org.sami.crw.decision.SimulatedOperator;
import org.sami.crw.session.SessionOperator.Asked;
import org.sami.crw.sim.run.operator.AnswerSource;
import org.sami.spn.json.Reading;
import org.sami.spn.protocol.Answer;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** Answers of a scripted operator: the script's boats, places and unvisited locations, and otherwise what the simulated operator says. */
final class ScriptedAnswers implements AnswerSource {
    private static final ValueType POINTS = new ValueType.ListOf(ValueType.Simple.POINT);

    private final SimulatedOperator others;
    private final Map<String, Value> places;
    private final List<IncidentScript.AnswerDelay> delays;
    private final LocationsToVisit locations;
    private final BackgroundWork background;
    private final Map<String, List<String>> boatsOf = new HashMap<>(); // by plan; absent = all

    ScriptedAnswers(
            SimulatedOperator others,
            Map<String, Value> places,
            List<IncidentScript.AnswerDelay> delays,
            LocationsToVisit locations,
            BackgroundWork background) {
        this.others = others;
        this.places = places;
        this.delays = delays;
        this.locations = locations;
        this.background = background;
    }

    /** Chooses these boats from now on where a plan asks for boats. */
    void choose(String plan, Optional<List<String>> boats) {
        boats.ifPresentOrElse(some -> boatsOf.put(plan, some), () -> boatsOf.remove(plan));
    }

    @Override
    public long furtherMillis(Asked asked) {
        long waiting = background.waitMillis(asked);
        return waiting
                + delays.stream()
                        .filter(delay -> delay.plan().equals(asked.plan())
                                && delay.event().equals(asked.decision().type()))
                        .mapToLong(IncidentScript.AnswerDelay::millis)
                        .sum();
    }

    @Override
    public Reading<Answer> answer(Decision decision, String plan) {
        List<String> chosen = boatsOf.get(plan);
        if (chosen != null
                && decision.question() instanceof Question.ChooseProxies choice
                && DomainQuestion.of(decision.type()).isEmpty()) {
            List<String> offered = new ArrayList<>(choice.proxies());
            offered.retainAll(chosen);
            return new Reading<>(Optional.of(new Answer.Proxies(offered)), List.of());
        }
        Reading<Answer> usual = others.answer(decision, plan);
        return decision.question() instanceof Question.FillIn asked ? filled(asked, usual) : usual;
    }

    private Reading<Answer> filled(Question.FillIn asked, Reading<Answer> usual) {
        Map<String, Value> values = new LinkedHashMap<>();
        if (usual.result().orElse(null) instanceof Answer.Fields fields) {
            values.putAll(fields.values());
        }
        for (Question.Item item : asked.items()) {
            if (item.editable() && places.containsKey(item.key())) {
                values.put(item.key(), places.get(item.key()));
            } else if (item.type().equals(POINTS) && values.get(item.key()) instanceof ListValue drawn) {
                values.put(item.key(), locations.given(drawn));
            }
        }
        boolean isWhole = asked.items().stream().allMatch(item -> values.containsKey(item.key()));
        return isWhole ? new Reading<>(Optional.of(new Answer.Fields(values)), List.of()) : usual;
    }
}
