package org.sami.crw.judgement;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.Value;

/**
 * Reads the criteria for values without a question from the engine's state: start values of a mission and values of globals. On the engine's thread.
 */
public final class StartReader {
    private static final Question NONE_ASKED = new Question.FillIn(List.of());

    private final EngineView view;

    private StartReader(EngineView view) {
        this.view = view;
    }

    /**
     * What the values are judged by with which a mission of a plan is to start; empty where there is no such plan.
     *
     * @param given the names of the values: fields as {@code event.field}, variables with their {@code @}
     */
    public static Optional<JudgedQuestion> plan(String plan, Set<String> given, EngineView view) {
        return view.plan(plan).map(found -> new StartReader(view).read(found, given));
    }

    private JudgedQuestion read(Plan plan, Set<String> given) {
        Map<String, Value> variables = new HashMap<>(view.globals());
        plan.variables()
                .forEach(variable -> variable.initial().ifPresent(value -> variables.put(variable.name(), value)));
        return question(
                plan.places().stream()
                        .flatMap(place -> place.outputs().stream())
                        .map(output -> request(output, given, variables))
                        .filter(request -> !request.asked().isEmpty())
                        .toList(),
                view.proxies());
    }

    /** What a new value of a global is judged by: where plans read it, and where boats may be; not by what work would take. */
    public static JudgedQuestion global(String name, EngineView view) {
        StartReader reader = new StartReader(view);
        return reader.question(
                view.project().plans().stream()
                        .flatMap(plan -> plan.places().stream())
                        .flatMap(place -> place.outputs().stream())
                        .map(output -> new JudgedRequest(output.type(), Map.of(), readers(output, Set.of(name))))
                        .filter(request -> !request.asked().isEmpty())
                        .distinct()
                        .toList(),
                List.of());
    }

    private JudgedQuestion question(List<JudgedRequest> requests, List<String> boats) {
        return new JudgedQuestion(
                NONE_ASKED, requests, List.of(), WayLimits.of(Ids.NONE, view), OperatingArea.of(view), false, boats);
    }

    private static Map<String, String> readers(OutputEventSpec output, Set<String> given) {
        Map<String, String> asked = new HashMap<>();
        output.fields().forEach((field, source) -> {
            if (source instanceof FieldSource.FromVariable read && given.contains(read.variable())) {
                asked.put(field, read.variable());
            }
        });
        return asked;
    }

    private JudgedRequest request(OutputEventSpec output, Set<String> given, Map<String, Value> variables) {
        Map<String, Value> known = JudgedRequest.defaults(view.vocabulary(), output.type());
        Map<String, String> asked = readers(output, given);
        output.fields().forEach((field, source) -> {
            String key = output.id() + "." + field;
            if (source instanceof FieldSource.Fixed fixed) {
                known.put(field, fixed.value());
            } else if (source instanceof FieldSource.FromVariable read && variables.containsKey(read.variable())) {
                known.put(field, variables.get(read.variable()));
            } else if (source instanceof FieldSource.Asked && given.contains(key)) {
                asked.put(field, key);
            } else if (source instanceof FieldSource.Asked later) {
                later.defaultValue().ifPresent(value -> known.put(field, value));
            }
        });
        return new JudgedRequest(output.type(), known, asked);
    }
}
