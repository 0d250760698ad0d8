package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.Collections;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** What people read of values that are answered, offered and set. */
class ValueWordsTest {
    private static final GeoArea SQUARE = new GeoArea(
            List.of(GeoPoint.of(45, 10), GeoPoint.of(45, 11), GeoPoint.of(46, 11), GeoPoint.of(46, 10)), List.of());

    @Test
    void areaIsToldByItsCornersAndItsMiddle() {
        assertThat(ValueWords.of(SQUARE)).isEqualTo("an area of 4 corners around 45.500000/10.500000");
        assertThat(ValueWords.of(new GeoArea(SQUARE.outline(), List.of(SQUARE.outline()))))
                .endsWith("45.500000/10.500000, with 1 hole");
    }

    @Test
    void longListIsToldByHowManyThereAre() {
        List<GeoPoint> many = Collections.nCopies(9, GeoPoint.of(45, 10));

        assertThat(ValueWords.of(new ListValue(List.<Value>copyOf(many)))).isEqualTo("9 points");
        assertThat(ValueWords.of(new GeoPath(many))).isEqualTo("9 points");
        assertThat(ValueWords.of(new ListValue(Collections.<Value>nCopies(5, SQUARE))))
                .isEqualTo("5 areas");
    }

    @Test
    void figuresOfAnOptionHaveTheirUnitsAndNamesInWords() {
        RecordValue allocation = new RecordValue(
                "Allocation",
                Map.of("totalLengthM", new RealValue(183.04), "method", new TextValue("Sequential auction")));

        assertThat(ValueWords.label(allocation).split(", "))
                .containsExactlyInAnyOrder("total length 183.0 m", "method Sequential auction");
    }
}
