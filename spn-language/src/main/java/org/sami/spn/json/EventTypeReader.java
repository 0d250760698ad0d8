package org.sami.spn.json;

import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.sami.spn.vocabulary.AnswerNames;
import org.sami.spn.vocabulary.AutonomyAnswer;
import org.sami.spn.vocabulary.DecisionForm;
import org.sami.spn.vocabulary.DecisionType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventFlag;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.TokenNeed;

/** Reads declarations of event types. */
final class EventTypeReader {
    private final FieldTypeReader fields;

    EventTypeReader(FieldTypeReader fields) {
        this.fields = fields;
    }

    Optional<EventType> read(JsonObjectReader m, Names taken) {
        String name = m.text("name");
        taken.take(name, m.pointer());
        List<String> aliases = m.texts("aliases");
        aliases.forEach(alias -> taken.take(alias, m.at("aliases")));
        Optional<Direction> direction = m.word("direction", Direction.class);
        EventType event = new EventType(
                name,
                aliases,
                direction.orElse(Direction.OUTPUT),
                fields.fields(m, "fields"),
                m.word("tokens", TokenNeed.class, TokenNeed.NONE),
                m.texts("answers"),
                m.word("role", EventRole.class, EventRole.NONE),
                flags(m),
                m.object("decision").flatMap(this::decision),
                m.text("label"),
                m.text("help"));
        return direction.map(d -> event);
    }

    private Set<EventFlag> flags(JsonObjectReader m) {
        Set<EventFlag> flags = EnumSet.noneOf(EventFlag.class);
        for (String word : m.texts("flags")) {
            Optional<EventFlag> flag = Words.parse(EventFlag.class, word);
            flag.ifPresent(flags::add);
            if (flag.isEmpty()) {
                m.problem(Codes.UNKNOWN_WORD, "flags", "\"" + word + "\"" + Words.noneOf(EventFlag.class, word));
            }
        }
        return flags;
    }

    private Optional<DecisionType> decision(JsonObjectReader m) {
        Optional<DecisionForm> form = m.word("form", DecisionForm.class);
        String accepted = m.text("accepted");
        String rejected = m.text("rejected", "");
        int min = m.integer("min", 0);
        int max = m.integer("max", Integer.MAX_VALUE);
        String optionsField = m.text("optionsField", "");
        var answerFields = m.textMap("answerFields");
        AnswerNames names = m.word("names", AnswerNames.class, AnswerNames.NOBODY);
        AutonomyAnswer autonomy = m.word("autonomy", AutonomyAnswer.class, AutonomyAnswer.NONE);
        m.done();
        if (min < 0 || max < min) {
            m.problem(Codes.BAD_VALUE, "", "Not a range of choices: " + min + " to " + max);
            return Optional.empty();
        }
        return form.map(
                f -> new DecisionType(f, accepted, rejected, min, max, optionsField, answerFields, names, autonomy));
    }
}
