package org.sami.crw.judgement;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.activation.PlannedSwaps;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.spn.engine.EngineView;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InEdge;
import org.sami.spn.model.OutputEventSpec;
import org.sami.spn.model.Plan;
import org.sami.spn.protocol.Activation;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Question;
import org.sami.spn.protocol.Token;
import org.sami.spn.value.Value;

/**
 * Reads from the engine's state what the answers to a decision are judged by: where in the asking plan the values go, and what chosen boats come to next. On
 * the engine's thread.
 */
public final class QuestionReader {
    private final Decision decision;
    private final EngineView view;
    private final Plan plan;
    private final Optional<Activation> asking;

    private QuestionReader(Decision decision, EngineView view, Plan plan) {
        this.decision = decision;
        this.view = view;
        this.plan = plan;
        asking = view.activation(decision.activation());
    }

    /** What a decision is judged by; empty where no mission asks, or it has ended. */
    public static Optional<JudgedQuestion> read(Decision decision, EngineView view) {
        return decision.mission() == Ids.NONE
                ? Optional.empty()
                : view.planOf(decision.mission()).map(plan -> new QuestionReader(decision, view, plan).read());
    }

    private JudgedQuestion read() {
        Map<String, String> written = written();
        List<JudgedRequest> requests = new ArrayList<>();
        plan.places().stream()
                .flatMap(place -> place.outputs().stream())
                .map(output -> request(output, written))
                .filter(request -> !request.asked().isEmpty())
                .forEach(requests::add);
        return new JudgedQuestion(
                decision.question(),
                requests,
                next().stream().map(output -> request(output, Map.of())).toList(),
                WayLimits.of(decision.mission(), view),
                OperatingArea.of(view),
                PlannedSwaps.areOf(decision.mission(), view),
                boats());
    }

    private List<Question.Item> items() {
        return decision.question() instanceof Question.FillIn asked ? asked.items() : List.of();
    }

    /** The items by the variables that receive them. */
    private Map<String, String> written() {
        Map<String, String> written = new HashMap<>();
        items().stream()
                .map(Question.Item::key)
                .filter(key -> key.startsWith("@"))
                .forEach(key -> written.put(key, key));
        Optional<String> accepted = view.vocabulary()
                .event(decision.type())
                .flatMap(type -> type.decision())
                .map(type -> type.accepted());
        Set<String> after = new HashSet<>(transitionsAfter());
        plan.transitions().stream()
                .filter(transition -> after.contains(transition.id()))
                .flatMap(transition -> transition.inputs().stream())
                .filter(input -> accepted.filter(input.type()::equals).isPresent())
                .forEach(input -> input.writes().forEach((field, variable) -> written.put(variable, field)));
        return written;
    }

    private List<String> transitionsAfter() {
        String place = asking.map(Activation::place).orElse("");
        return plan.inEdges().stream()
                .filter(edge -> edge.place().equals(place))
                .map(InEdge::transition)
                .toList();
    }

    private List<OutputEventSpec> next() {
        if (!(decision.question() instanceof Question.ChooseProxies)) {
            return List.of();
        }
        List<String> after = transitionsAfter();
        return plan.outEdges().stream()
                .filter(edge -> after.contains(edge.transition()))
                .map(edge -> edge.place())
                .distinct()
                .flatMap(place -> plan.place(place).stream())
                .flatMap(place -> place.outputs().stream())
                .toList();
    }

    private JudgedRequest request(OutputEventSpec output, Map<String, String> written) {
        Map<String, Value> known = JudgedRequest.defaults(view.vocabulary(), output.type());
        Map<String, String> asked = new HashMap<>();
        Set<String> keys =
                new HashSet<>(items().stream().map(Question.Item::key).toList());
        output.fields().forEach((field, source) -> {
            String key = output.id() + "." + field;
            if (source instanceof FieldSource.Fixed fixed) {
                known.put(field, fixed.value());
            } else if (source instanceof FieldSource.FromVariable read && written.containsKey(read.variable())) {
                asked.put(field, written.get(read.variable()));
            } else if (source instanceof FieldSource.FromVariable read) {
                view.variable(decision.mission(), read.variable()).ifPresent(value -> known.put(field, value));
            } else if (source instanceof FieldSource.Asked && keys.contains(key)) {
                asked.put(field, key);
            } else if (source instanceof FieldSource.Asked) {
                view.parameter(decision.mission(), key).ifPresent(value -> known.put(field, value));
            }
        });
        return new JudgedRequest(output.type(), known, asked);
    }

    /** The boats that stand in the mission; where none do, those that the session has. */
    private List<String> boats() {
        Set<String> standing = new LinkedHashSet<>();
        view.mission(decision.mission())
                .ifPresent(mission -> mission.marking()
                        .values()
                        .forEach(tokens -> tokens.forEach(token -> {
                            if (token instanceof Token.Proxy proxy) {
                                standing.add(proxy.proxy());
                            }
                        })));
        return standing.isEmpty() ? view.proxies() : List.copyOf(standing);
    }
}
