package org.sami.crw.judgement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldLimits.Range;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Vocabulary;

/** What is judged while an operator answers, and what checks of plans hold values against, are the same numbers. */
class FieldRulesTest {
    private static final int RANGES = 8;
    private static final Vocabulary WORDS =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow().vocabulary();

    @Test
    void rangesOfTheVocabularyAreThoseOfTheRules() {
        List<String> compared = new ArrayList<>();
        for (EventType event : WORDS.events().values()) {
            for (FieldType field : event.fields()) {
                String name = event.name() + "." + field.name();
                Range range = field.limits().range();
                if (FieldRules.fields().contains(name) && !range.equals(Range.ALL)) {
                    compared.add(name);
                    assertThat(wrong(event, field, range.least())).as(name).isFalse();
                    assertThat(wrong(event, field, range.most())).as(name).isFalse();
                    assertThat(wrong(event, field, range.least() - 1)).as(name).isTrue();
                    assertThat(wrong(event, field, range.most() + 1)).as(name).isTrue();
                }
            }
        }
        assertThat(compared).hasSize(RANGES);
    }

    private static boolean wrong(EventType event, FieldType field, double number) {
        Value value =
                field.type() == ValueType.Simple.INTEGER ? new IntegerValue((long) number) : new RealValue(number);
        return FieldRules.wrong(event.name(), field.name(), value).isPresent();
    }
}
