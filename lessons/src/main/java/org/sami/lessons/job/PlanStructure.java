package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.json.ValueJson;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.model.Place;
import org.sami.spn.model.Plan;
import org.sami.spn.model.Project;
import org.sami.spn.model.SubMissionSpec;
import org.sami.spn.model.Transition;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.MarkupType;
import org.sami.spn.vocabulary.Vocabulary;

/** What a plan and the plans that it runs as sub-missions are made of, as predicates ask it: by types of events, never by ids or names. */
final class PlanStructure {
    private static final String INTERRUPT_NAME = "interruptName";

    private final Vocabulary vocabulary;
    private final Plan plan;
    private final List<Plan> plans;
    private final List<NetOfKinds> nets;
    private final List<Event> events = new ArrayList<>();

    /** An event on a vertex; output events have sources of fields, input events fixed values. */
    record Event(
            String type,
            Map<String, FieldSource> fields,
            Map<String, String> writes,
            List<MarkupSpec> markups,
            String vertex) {}

    PlanStructure(Project project, Plan plan, Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
        this.plan = plan;
        plans = withSubMissions(project, plan);
        nets = plans.stream().map(one -> new NetOfKinds(one, vocabulary)).toList();
        for (Plan one : plans) {
            for (Place place : one.places()) {
                place.outputs()
                        .forEach(output -> events.add(new Event(
                                canonical(output.type()),
                                output.fields(),
                                output.writes(),
                                output.markups(),
                                one.id() + "/" + place.id())));
            }
            for (Transition transition : one.transitions()) {
                transition.inputs().forEach(input -> {
                    Map<String, FieldSource> fields = new LinkedHashMap<>();
                    input.fields().forEach((name, value) -> fields.put(name, new FieldSource.Fixed(value)));
                    events.add(new Event(
                            canonical(input.type()),
                            fields,
                            input.writes(),
                            input.markups(),
                            one.id() + "/" + transition.id()));
                });
            }
        }
    }

    private static List<Plan> withSubMissions(Project project, Plan plan) {
        Set<Plan> found = new LinkedHashSet<>(List.of(plan));
        Deque<Plan> open = new ArrayDeque<>(List.of(plan));
        while (!open.isEmpty()) {
            for (Place place : open.pop().places()) {
                for (SubMissionSpec sub : place.subMissions()) {
                    project.plan(sub.plan()).filter(found::add).ifPresent(open::push);
                }
            }
        }
        return List.copyOf(found);
    }

    Plan plan() {
        return plan;
    }

    private String canonical(String type) {
        return vocabulary.event(type).map(EventType::name).orElse(type);
    }

    // ---- Events

    List<Event> events(String type) {
        String name = canonical(type);
        return events.stream().filter(event -> event.type().equals(name)).toList();
    }

    boolean haveBoth(String type, String with) {
        Set<String> vertices = new LinkedHashSet<>();
        events(with).forEach(event -> vertices.add(event.vertex()));
        return events(type).stream().anyMatch(event -> vertices.contains(event.vertex()));
    }

    boolean comes(Event event, String field, String from, Optional<JsonNode> is, String variable) {
        Optional<FieldSource> source = Optional.ofNullable(event.fields().get(field));
        return (from.isEmpty() || from.equals(word(source)))
                && (variable.isEmpty()
                        || source.equals(Optional.of(new FieldSource.FromVariable(variable)))
                        || variable.equals(event.writes().get(field)))
                && (is.isEmpty() || value(source).equals(read(is.get(), type(event, field))));
    }

    private static String word(Optional<FieldSource> source) {
        if (source.isEmpty()) {
            return "none";
        }
        FieldSource from = source.get();
        return from instanceof FieldSource.Fixed
                ? "value"
                : from instanceof FieldSource.FromVariable
                        ? "variable"
                        : from instanceof FieldSource.FromTask ? "task" : "ask";
    }

    private static Optional<Value> value(Optional<FieldSource> source) {
        return source.flatMap(from -> from instanceof FieldSource.Fixed fixed
                ? Optional.of(fixed.value())
                : from instanceof FieldSource.Asked asked ? asked.defaultValue() : Optional.empty());
    }

    private Optional<ValueType> type(Event event, String field) {
        return vocabulary.event(event.type()).flatMap(type -> type.field(field)).map(FieldType::type);
    }

    private Optional<Value> read(JsonNode node, Optional<ValueType> type) {
        return type.flatMap(
                known -> ValueJson.read(node, known, vocabulary.types()).result());
    }

    Set<String> variablesWritten(String writer, String field) {
        Set<String> variables = new LinkedHashSet<>();
        events(writer)
                .forEach(event -> Optional.ofNullable(event.writes().get(field)).ifPresent(variables::add));
        return variables;
    }

    Optional<String> variableRead(Event event, String field) {
        return event.fields().get(field) instanceof FieldSource.FromVariable from
                ? Optional.of(from.variable())
                : Optional.empty();
    }

    boolean hasMarkup(Event event, String type, Map<String, JsonNode> options) {
        Optional<MarkupType> wanted = vocabulary.markup(type);
        return event.markups().stream()
                .filter(markup ->
                        wanted.isPresent() && vocabulary.markup(markup.type()).equals(wanted))
                .anyMatch(markup -> options.entrySet().stream()
                        .allMatch(option -> markup.option(option.getKey())
                                .equals(read(option.getValue(), optionType(wanted.get(), option.getKey())))));
    }

    private static Optional<ValueType> optionType(MarkupType markup, String option) {
        return markup.options().stream()
                .filter(field -> field.name().equals(option))
                .map(FieldType::type)
                .findFirst();
    }

    Set<String> interrupts() {
        Set<String> names = new LinkedHashSet<>();
        for (Event event : events) {
            EventRole role = vocabulary.event(event.type()).map(EventType::role).orElse(EventRole.NONE);
            boolean offers = switch (role) {
                case INTERRUPT, GENERAL_INTERRUPT, PROXY_INTERRUPT -> true;
                default -> false;
            };
            if (offers
                    && value(Optional.ofNullable(event.fields().get(INTERRUPT_NAME)))
                                    .orElse(null)
                            instanceof TextValue t) {
                names.add(t.value());
            }
        }
        return names;
    }

    boolean runs(String child) {
        return plans.stream()
                .flatMap(one -> one.places().stream())
                .flatMap(place -> place.subMissions().stream())
                .anyMatch(sub -> sub.plan().equals(child));
    }

    // ---- Edges

    boolean edgeRequires(String from, String to, Map<String, JsonNode> wanted) {
        return nets.stream().anyMatch(net -> net.edgeRequires(from, to, wanted));
    }

    boolean silentEdgeRequires(Map<String, JsonNode> wanted) {
        return nets.stream().anyMatch(net -> net.silentEdgeRequires(wanted));
    }

    boolean leads(String from, String to, String through) {
        return nets.stream().anyMatch(net -> net.leads(from, to, through));
    }
}
