package org.sami.spn.json;

import static org.assertj.core.api.Assertions.assertThat;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.json.JsonMapper;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.InRequirement;
import org.sami.spn.model.Match;
import org.sami.spn.model.TokenKind;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** Parts of a plan are read as in a project, and what is wrong is named with its place in the part. */
class PartReaderTest {
    private static final FieldType DURATION =
            new FieldType("duration", ValueType.Simple.DURATION, "", true, Optional.empty(), "");

    private final PartReader reader = new PartReader(new Vocabulary("d", List.of(), List.of(), List.of(), List.of()));

    private static JsonNode json(String text) {
        try {
            return new JsonMapper().readTree(text.replace('\'', '"'));
        } catch (JsonProcessingException e) {
            throw new AssertionError(e);
        }
    }

    private static List<String> pointers(Reading<?> reading) {
        assertThat(reading.result()).isEmpty();
        return reading.findings().stream().map(Finding::pointer).toList();
    }

    @Test
    void requirementsOfAnEdgeAreReadAlone() {
        assertThat(reader.inRequirements(json("[{'kind': 'generic', 'match': 'at-least', 'n': 2}]"))
                        .orThrow())
                .containsExactly(InRequirement.of(TokenKind.GENERIC, Match.AT_LEAST, 2));
        assertThat(reader.outRequirements(json("[{'kind': 'generic', 'action': 'take', 'n': 'all'}]"))
                        .orThrow())
                .hasSize(1);
        assertThat(pointers(reader.inRequirements(json("[{'kind': 'unconditional'}, {'kind': 'boat'}]"))))
                .containsExactly("/1/kind");
        assertThat(pointers(reader.outRequirements(json("{'kind': 'generic'}"))))
                .containsExactly("");
    }

    @Test
    void aSourceIsReadByTheTypeOfItsField() {
        assertThat(reader.source(json("{'value': 'PT10S'}"), DURATION).orThrow())
                .isEqualTo(new FieldSource.Fixed(new DurationValue(10_000)));
        assertThat(reader.source(json("{'variable': '@task'}"), DURATION).orThrow())
                .isEqualTo(new FieldSource.FromTask());
        assertThat(pointers(reader.source(json("{'value': 'soon'}"), DURATION))).containsExactly("/value");
    }

    @Test
    void valuesAreReadByTheirFields() {
        assertThat(reader.values(json("{'duration': 'PT1S'}"), List.of(DURATION), "event E")
                        .orThrow())
                .isEqualTo(Map.of("duration", new DurationValue(1000)));
        assertThat(pointers(reader.values(json("{'time': 'PT1S'}"), List.of(DURATION), "event E")))
                .containsExactly("/time");
    }

    @Test
    void declarationsAreReadAlone() {
        assertThat(reader.variable(json("{'name': '@x', 'type': 'integer', 'initial': 3}"))
                        .orThrow()
                        .name())
                .isEqualTo("@x");
        assertThat(pointers(reader.variable(json("{'name': 'x', 'type': 'integer'}"))))
                .containsExactly("/name");
        assertThat(pointers(reader.markup(json("{'type': 'None'}")))).containsExactly("/type");
        assertThat(pointers(reader.task(json("{'name': 'T', 'class': 'None'}"))))
                .containsExactly("/class");
    }
}
