package org.sami.lessons.job;

import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import org.sami.spn.finding.Finding;
import org.sami.spn.finding.Suggestions;
import org.sami.spn.json.JsonObjectReader;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.Vocabulary;

/** What is wrong with a job's file. */
final class JobFormat implements JsonObjectReader.Format {
    static final String CODE = "E-JOB";

    private final Vocabulary vocabulary;
    private final List<Finding> findings = new ArrayList<>();

    JobFormat(Vocabulary vocabulary) {
        this.vocabulary = vocabulary;
    }

    Vocabulary vocabulary() {
        return vocabulary;
    }

    List<Finding> findings() {
        return findings;
    }

    @Override
    public void add(Finding finding) {
        findings.add(finding);
    }

    @Override
    public boolean nullIsAbsent() {
        return true;
    }

    @Override
    public String emptyCode() {
        return CODE;
    }

    @Override
    public Finding unknownMember(String pointer, String member, Set<String> known) {
        return Finding.error(
                CODE,
                pointer,
                "\"" + member + "\" is no member here; known are "
                        + String.join(", ", known.stream().sorted().toList()));
    }

    void problem(String pointer, String message) {
        add(Finding.error(CODE, pointer, message));
    }

    /** The name of an event type; one that there is not is a problem. */
    String event(String name, String pointer) {
        if (!name.isEmpty() && vocabulary.event(name).isEmpty()) {
            problem(
                    pointer,
                    "There is no event \"" + name + "\""
                            + Suggestions.meant(vocabulary.events().keySet(), name));
        }
        return vocabulary.event(name).map(EventType::name).orElse(name);
    }

    /** Likewise one that a place, or a transition, can have. */
    String event(String name, Direction direction, String pointer) {
        vocabulary.event(name).filter(type -> type.direction() != direction).ifPresent(type -> {
            String what = direction == Direction.OUTPUT ? "an output event" : "an input event";
            problem(pointer, "\"" + name + "\" is not " + what);
        });
        return event(name, pointer);
    }

    /** A field of an event type; one that it has not is a problem. */
    void field(String event, String field, String pointer) {
        vocabulary.event(event).filter(type -> type.field(field).isEmpty()).ifPresent(type -> {
            List<String> fields = type.fields().stream().map(one -> one.name()).toList();
            problem(
                    pointer,
                    "The event " + event + " has no field \"" + field + "\"; it has "
                            + (fields.isEmpty() ? "none" : String.join(", ", fields)));
        });
    }
}
