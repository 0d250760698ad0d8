package org.sami.crw.decision;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalLong;
import org.junit.jupiter.api.Test;
import org.sami.spn.model.MarkupSpec;
import org.sami.spn.protocol.Decision;
import org.sami.spn.protocol.Ids;
import org.sami.spn.protocol.Priority;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;

/** What the markup Default Location fills in where a location is asked for. */
class ProposedLocationTest {
    private static final GeoPoint HOME = GeoPoint.of(25.36, 51.53);
    private static final GeoArea WATER = new GeoArea(
            List.of(GeoPoint.of(25, 51), GeoPoint.of(25, 53), GeoPoint.of(27, 53), GeoPoint.of(27, 51)), List.of());
    private static final Map<String, Value> BEACH = Map.of("@home", HOME, "@water", WATER);

    private static Optional<Value> proposed(
            String location, ValueType type, Optional<Value> own, Map<String, Value> globals) {
        Question.Item item = new Question.Item("@station", type, "", own, true, "");
        MarkupSpec markup =
                new MarkupSpec("DefaultLocation", Map.of("location", new EnumValue("LocationDefault", location)));
        Decision decision = new Decision(
                1,
                Ids.NONE,
                Ids.NONE,
                "RedefineVariables",
                "Where?",
                new Question.FillIn(List.of(item)),
                Optional.empty(),
                OptionalLong.empty(),
                Priority.MEDIUM,
                List.of(markup));
        Question.FillIn asked =
                (Question.FillIn) ProposedLocation.in(decision, globals).question();
        return asked.items().get(0).defaultValue();
    }

    @Test
    void quayIsTheProjectsHomeAndAreaTheMiddleOfItsWater() {
        assertThat(proposed("QUAY", ValueType.Simple.POINT, Optional.empty(), BEACH))
                .contains(HOME);
        assertThat(proposed("AREA", ValueType.Simple.POINT, Optional.empty(), BEACH))
                .contains(GeoPoint.of(26, 52));
    }

    @Test
    void valueThatIsThereAlreadyStays() {
        GeoPoint own = GeoPoint.of(1, 2);

        assertThat(proposed("QUAY", ValueType.Simple.POINT, Optional.of(own), BEACH))
                .contains(own);
    }

    @Test
    void nothingIsProposedWhereTheProjectSaysNoneOrNoPointIsAskedFor() {
        assertThat(proposed("AREA", ValueType.Simple.POINT, Optional.empty(), Map.of()))
                .isEmpty();
        assertThat(proposed("QUAY", ValueType.Simple.REAL, Optional.empty(), BEACH))
                .isEmpty();
    }
}
