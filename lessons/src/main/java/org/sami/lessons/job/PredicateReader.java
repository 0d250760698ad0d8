package org.sami.lessons.job;

import com.fasterxml.jackson.databind.JsonNode;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.sami.spn.json.JsonObjectReader;

/** Reads predicates of jobs: each by the member that says what it asks. */
final class PredicateReader {
    private static final List<String> KINDS = List.of(
            "written",
            "field",
            "markup",
            "edge",
            "silent-edge",
            "path",
            "start",
            "end",
            "places",
            "transitions",
            "straight",
            "interrupt",
            "runs",
            "finding",
            "case",
            "not",
            "any",
            "event");
    private static final Set<String> SOURCES = Set.of("value", "variable", "task", "ask", "none");
    private static final Set<String> VERTICES = Set.of("start", "end", "blank");

    private final JobFormat format;
    private final Set<String> cases;

    /**
     * A reader.
     *
     * @param cases the names of the job's cases
     */
    PredicateReader(JobFormat format, Set<String> cases) {
        this.format = format;
        this.cases = new LinkedHashSet<>(cases);
    }

    /** A predicate, or a list of them that must all hold. */
    List<JobPredicate> all(JsonNode node, String pointer) {
        List<JobPredicate> read = new ArrayList<>();
        if (node.isArray()) {
            for (int i = 0; i < node.size(); i++) {
                one(node.get(i), pointer + "/" + i).ifPresent(read::add);
            }
        } else {
            one(node, pointer).ifPresent(read::add);
        }
        return read;
    }

    private Optional<JobPredicate> one(JsonNode node, String pointer) {
        return JsonObjectReader.of(node, pointer, format).flatMap(members -> {
            Optional<JobPredicate> read = read(members);
            members.done();
            return read;
        });
    }

    /** The predicate among an object's members; what else stands in the object is left to the caller. */
    Optional<JobPredicate> read(JsonObjectReader m) {
        Optional<String> kind = KINDS.stream().filter(m::has).findFirst();
        if (kind.isEmpty()) {
            m.problem(JobFormat.CODE, "", "This is no predicate: it has none of " + String.join(", ", KINDS));
            return Optional.empty();
        }
        return switch (kind.get()) {
            case "event" -> Optional.of(event(m));
            case "field" -> Optional.of(field(m));
            case "written" -> Optional.of(written(m));
            case "markup" -> Optional.of(markup(m));
            case "edge" -> {
                List<String> ends = ends(m, "edge");
                yield ends.isEmpty()
                        ? Optional.empty()
                        : Optional.of(
                                new JobPredicate.EdgeRequires(ends.get(0), ends.get(1), requirement(m, "requires")));
            }
            case "silent-edge" -> Optional.of(new JobPredicate.SilentEdge(requirement(m, "silent-edge")));
            case "path" -> {
                List<String> ends = ends(m, "path");
                String through = m.has("through") ? vertex(m.text("through"), m.at("through")) : "";
                yield ends.isEmpty()
                        ? Optional.empty()
                        : Optional.of(new JobPredicate.HasPath(ends.get(0), ends.get(1), through));
            }
            case "start" -> Optional.of(new JobPredicate.HasStart(m.flag("start")));
            case "end" -> Optional.of(new JobPredicate.EndPlaces(m.integer("end", 1)));
            case "places" -> Optional.of(new JobPredicate.VertexCount(m.integer("places", 0), true));
            case "transitions" -> Optional.of(new JobPredicate.VertexCount(m.integer("transitions", 0), false));
            case "straight" -> Optional.of(new JobPredicate.IsStraight(m.flag("straight")));
            case "interrupt" -> Optional.of(new JobPredicate.HasInterrupt(m.text("interrupt")));
            case "runs" -> Optional.of(new JobPredicate.Runs(m.text("runs")));
            case "finding" -> Optional.of(new JobPredicate.HasFinding(m.text("finding")));
            case "case" -> went(m);
            case "not" -> m.node("not").flatMap(node -> one(node, m.at("not"))).map(JobPredicate.Not::new);
            default -> Optional.of(new JobPredicate.AnyOf(all(m.node("any").orElseThrow(), m.at("any"))));
        };
    }

    private JobPredicate event(JsonObjectReader m) {
        String type = format.event(m.text("event"), m.at("event"));
        if (m.has("with")) {
            return new JobPredicate.EventWith(type, format.event(m.text("with"), m.at("with")));
        }
        return new JobPredicate.HasEvent(
                type, m.has("count") ? OptionalInt.of(m.integer("count", 1)) : OptionalInt.empty());
    }

    /** {@code EVENT.FIELD} as the two. */
    private List<String> eventField(JsonObjectReader m, String member) {
        String text = m.text(member);
        int dot = text.indexOf('.');
        if (dot <= 0) {
            m.problem(JobFormat.CODE, member, "An event and its field are wanted, as in ProxyGotoPoint.points");
            return List.of("", "");
        }
        String event = format.event(text.substring(0, dot), m.at(member));
        format.field(event, text.substring(dot + 1), m.at(member));
        return List.of(event, text.substring(dot + 1));
    }

    private JobPredicate field(JsonObjectReader m) {
        List<String> field = eventField(m, "field");
        String from = m.text("from", "");
        if (!from.isEmpty() && !SOURCES.contains(from)) {
            m.problem(JobFormat.CODE, "from", "\"" + from + "\" is none of value, variable, task, ask, none");
        }
        return new JobPredicate.FieldFrom(field.get(0), field.get(1), from, m.node("is"), m.text("variable", ""));
    }

    private JobPredicate written(JsonObjectReader m) {
        List<String> written = eventField(m, "written");
        List<String> read = eventField(m, "read");
        return new JobPredicate.WrittenAndRead(written.get(0), written.get(1), read.get(0), read.get(1));
    }

    private JobPredicate markup(JsonObjectReader m) {
        String event = format.event(m.text("markup"), m.at("markup"));
        String type = m.text("type");
        if (!type.isEmpty() && format.vocabulary().markup(type).isEmpty()) {
            m.problem(JobFormat.CODE, "type", "There is no markup \"" + type + "\"");
        }
        Map<String, JsonNode> options = new LinkedHashMap<>();
        m.map("options").forEach((name, element) -> options.put(name, element.node()));
        return new JobPredicate.HasMarkup(event, type, options);
    }

    private List<String> ends(JsonObjectReader m, String member) {
        List<String> ends = m.texts(member);
        if (ends.size() != 2) {
            m.problem(JobFormat.CODE, member, "Two vertices are wanted, from and to");
            return List.of();
        }
        return List.of(vertex(ends.get(0), m.at(member) + "/0"), vertex(ends.get(1), m.at(member) + "/1"));
    }

    private String vertex(String kind, String pointer) {
        return VERTICES.contains(kind) || kind.startsWith(NetOfKinds.BY_NAME) ? kind : format.event(kind, pointer);
    }

    private Map<String, JsonNode> requirement(JsonObjectReader m, String member) {
        Map<String, JsonNode> wanted = new LinkedHashMap<>();
        m.map(member).forEach((name, element) -> {
            if (!RequirementMembers.NAMES.contains(name)) {
                format.problem(element.pointer(), "A requirement has no member \"" + name + "\"");
            }
            wanted.put(name, element.node());
        });
        return wanted;
    }

    private Optional<JobPredicate> went(JsonObjectReader m) {
        String name = m.text("case");
        if (!cases.contains(name)) {
            m.problem(JobFormat.CODE, "case", "The job has no case \"" + name + "\"");
        }
        String word = m.text("is", "different");
        for (CaseEnd how : CaseEnd.values()) {
            if (how.name().toLowerCase(Locale.ROOT).replace('_', '-').equals(word)) {
                return Optional.of(new JobPredicate.CaseWent(name, how));
            }
        }
        m.problem(
                JobFormat.CODE,
                "is",
                "\"" + word + "\" is none of same, different, never-ends, ends-early, asks-nobody, endless, refused");
        return Optional.empty();
    }
}
