package org.sami.spn.json;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.model.Plan;
import org.sami.spn.model.TokenKind;
import org.sami.spn.model.WaitFor;
import org.sami.spn.sequence.AuthoringLibrary;
import org.sami.spn.sequence.EventCategory;
import org.sami.spn.sequence.Sequence;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** Reads the groups of events and the sequences of a domain, or says everything that is wrong with them (docs/authoring.md). */
public final class AuthoringReader {
    /** The version of the format that is read and shipped. */
    public static final int FORMAT_VERSION = 1;

    private final Vocabulary vocabulary;
    private final Problems problems = new Problems();
    private final RequirementReader requirements = new RequirementReader();

    private AuthoringReader(Vocabulary vocabulary) {
        this.vocabulary = Objects.requireNonNull(vocabulary, "vocabulary");
    }

    /** The groups and sequences of a file's text, whose events are those of the vocabulary. */
    public static Reading<AuthoringLibrary> read(String text, Vocabulary vocabulary) {
        return new AuthoringReader(vocabulary).read(text);
    }

    private Reading<AuthoringLibrary> read(String text) {
        return JsonText.parse(text, problems)
                .flatMap(node -> JsonObjectReader.of(node, "", problems))
                .map(this::library)
                .map(library -> Reading.of(library, problems))
                .orElseGet(() -> Reading.nothing(problems));
    }

    private AuthoringLibrary library(JsonObjectReader root) {
        int version = root.integer("formatVersion", 0);
        if (version != FORMAT_VERSION) {
            root.problem(
                    Codes.VERSION,
                    "formatVersion",
                    "This program reads authoring files of version " + FORMAT_VERSION + ", not " + version);
        }
        root.text(ProjectReader.SCHEMA, "");
        List<EventCategory> categories = categories(root);
        Names ids = new Names(problems);
        List<Sequence> sequences = new ArrayList<>();
        for (JsonObjectReader m : root.objects("sequences")) {
            sequence(m).ifPresent(s -> {
                ids.take(s.event() + " " + s.id(), m.pointer());
                sequences.add(s);
            });
            m.done();
        }
        Map<String, String> help = root.textMap("requirements");
        help.keySet().stream()
                .filter(kind -> !isKind(kind))
                .forEach(kind -> root.problem(
                        Codes.UNKNOWN_WORD, "requirements", "\"" + kind + "\"" + Words.noneOf(TokenKind.class, kind)));
        root.done();
        return new AuthoringLibrary(categories, sequences, help);
    }

    private static boolean isKind(String word) {
        return word.equals("implied-generic")
                || Words.parse(TokenKind.class, word).isPresent();
    }

    private List<EventCategory> categories(JsonObjectReader root) {
        Names ids = new Names(problems);
        Names placed = new Names(problems);
        List<EventCategory> categories = new ArrayList<>();
        for (JsonObjectReader m : root.objects("categories")) {
            String id = m.text("id");
            ids.take(id, m.at("id"));
            for (JsonObjectReader.Element e : m.array("events")) {
                placed.take(e.node().asText(), e.pointer());
            }
            categories.add(new EventCategory(id, m.text("name"), events(m, "events", Optional.empty())));
            m.done();
        }
        return categories;
    }

    private Optional<Sequence> sequence(JsonObjectReader m) {
        String name = m.text("event");
        Optional<EventType> event = Optional.ofNullable(vocabulary.events().get(name));
        if (event.isEmpty() && !name.isEmpty()) {
            unknown(m, "event", name, vocabulary.events().keySet());
        }
        if (m.has("manual")) {
            boolean pattern = m.flag("pattern", false);
            return m.object("manual").flatMap(part -> manual(part, event, pattern));
        }
        String help = m.text("help", "");
        return event.flatMap(e -> e.direction() == Direction.OUTPUT
                ? Optional.of(new Sequence.OfOutput(
                        e.name(),
                        help,
                        m.word("tokens", TokenNeed.class, TokenNeed.NONE),
                        events(m, "inputs", Optional.of(Direction.INPUT)),
                        fields(m, e)))
                : Optional.of(ofInput(m, e.name(), help)));
    }

    private Sequence ofInput(JsonObjectReader m, String event, String help) {
        return new Sequence.OfInput(
                event,
                help,
                events(m, "outputs", Optional.of(Direction.OUTPUT)),
                m.objects("in").stream()
                        .map(requirements::in)
                        .flatMap(Optional::stream)
                        .toList(),
                m.objects("out").stream()
                        .map(requirements::out)
                        .flatMap(Optional::stream)
                        .toList(),
                m.word("waitFor", WaitFor.class, WaitFor.EACH),
                m.flag("movesGeneric", true));
    }

    private Optional<Sequence> manual(JsonObjectReader part, Optional<EventType> event, boolean pattern) {
        Plan plan = new PlanReader(new PlanParts(vocabulary, problems), part, List.of(), new Names(problems)).read();
        if (event.isEmpty()) {
            return Optional.empty();
        }
        Set<String> anchors = new LinkedHashSet<>();
        String type = event.get().name();
        plan.places().stream()
                .filter(p -> p.outputs().stream().anyMatch(o -> o.type().equals(type)))
                .forEach(p -> anchors.add(p.id()));
        plan.transitions().stream()
                .filter(t -> t.inputs().stream().anyMatch(i -> i.type().equals(type)))
                .forEach(t -> anchors.add(t.id()));
        if (anchors.size() != 1) {
            part.problem(
                    Codes.MISSING,
                    "",
                    "A manual sequence has its event on one vertex; " + type + " stands on "
                            + (anchors.isEmpty() ? "none" : String.join(", ", anchors)));
            return Optional.empty();
        }
        return Optional.of(new Sequence.Manual(type, plan, anchors.iterator().next(), pattern));
    }

    /** Names of events of the vocabulary, of one direction where that is given. */
    private List<String> events(JsonObjectReader m, String member, Optional<Direction> direction) {
        List<String> known = vocabulary.events().values().stream()
                .filter(e -> direction.isEmpty() || direction.get() == e.direction())
                .map(EventType::name)
                .toList();
        List<String> events = new ArrayList<>();
        for (String name : m.texts(member)) {
            if (known.contains(name)) {
                events.add(name);
            } else {
                unknown(m, member, name, known);
            }
        }
        return events;
    }

    /** Names of fields of an event. */
    private static List<String> fields(JsonObjectReader m, EventType event) {
        List<String> known = event.fields().stream().map(FieldType::name).toList();
        List<String> fields = new ArrayList<>();
        for (String name : m.texts("wires")) {
            if (known.contains(name)) {
                fields.add(name);
            } else {
                m.problem(
                        Codes.UNKNOWN_FIELD,
                        "wires",
                        "\"" + name + "\" is no field of " + event.name() + NearMatches.meant(known, name));
            }
        }
        return fields;
    }

    private static void unknown(JsonObjectReader m, String member, String name, Collection<String> known) {
        m.problem(
                Codes.UNKNOWN_EVENT,
                member,
                "\"" + name + "\" is no event that can stand here" + NearMatches.meant(known, name));
    }
}
