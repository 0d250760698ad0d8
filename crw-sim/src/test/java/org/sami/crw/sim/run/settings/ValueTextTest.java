package org.sami.crw.sim.run.settings;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.spn.value.BooleanValue;
import org.sami.spn.value.DurationValue;
import org.sami.spn.value.EnumValue;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.NamedType;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.value.VariableReference;

class ValueTextTest {
    private static final Map<String, NamedType> TYPES =
            Map.of("Pace", new NamedType.Enumeration("Pace", List.of("SLOW", "FAST")));

    @ParameterizedTest
    @CsvSource({"90,90000", "90s,90000", "1.5 min,90000", "1500ms,1500", "1h,3600000", "PT20S,20000"})
    void readsDurations(String text, long millis) {
        assertThat(parse(text, ValueType.Simple.DURATION)).contains(new DurationValue(millis));
    }

    @Test
    void readsSimpleTypes() {
        assertThat(parse("yes", ValueType.Simple.BOOLEAN)).contains(new BooleanValue(true));
        assertThat(parse("-4", ValueType.Simple.INTEGER)).contains(new IntegerValue(-4));
        assertThat(parse("2.5", ValueType.Simple.REAL)).contains(new RealValue(2.5));
        assertThat(parse(" a b ", ValueType.Simple.TEXT)).contains(new TextValue("a b"));
        assertThat(parse("boat2", ValueType.Simple.PROXY)).contains(new ProxyValue("boat2"));
        assertThat(parse("speed", ValueType.Simple.VARIABLE)).contains(new VariableReference("@speed"));
        assertThat(parse("45.7, 10.7", ValueType.Simple.POINT)).contains(GeoPoint.of(45.7, 10.7));
        assertThat(parse("fast", new ValueType.Named("Pace"))).contains(new EnumValue("Pace", "FAST"));
    }

    @Test
    void readsListsAndPaths() {
        GeoPoint first = GeoPoint.of(45.7, 10.7);
        GeoPoint second = new GeoPoint(45.8, 10.8, 3);

        assertThat(parse("45.7,10.7; 45.8,10.8,3", ValueType.Simple.PATH))
                .contains(new GeoPath(List.of(first, second)));
        assertThat(parse("45.7,10.7; 45.8,10.8,3", new ValueType.ListOf(ValueType.Simple.POINT)))
                .contains(new ListValue(List.of(first, second)));
        assertThat(parse("[{\"lat\": 45.7, \"lon\": 10.7}]", new ValueType.ListOf(ValueType.Simple.POINT)))
                .contains(new ListValue(List.of(first)));
    }

    @ParameterizedTest
    @CsvSource({
        "maybe,BOOLEAN",
        "1.5,INTEGER",
        "far,REAL",
        "soon,DURATION",
        "-5s,DURATION",
        "91;0,POINT",
        "91|0,POINT",
        "45.7,AREA",
        "job,TASK"
    })
    void takesNothingElse(String text, ValueType.Simple type) {
        assertThat(parse(text.replace('|', ','), type)).isEmpty();
    }

    @Test
    void everySimpleTypeSaysHowItIsTyped() {
        Map<ValueType.Simple, String> forms = new LinkedHashMap<>();
        for (ValueType.Simple type : ValueType.Simple.values()) {
            forms.put(type, ValueText.form(type));
        }

        assertThat(forms.values()).allSatisfy(form -> assertThat(form).isNotBlank());
    }

    private static Optional<Value> parse(String text, ValueType type) {
        return ValueText.parse(text, type, TYPES, new ArrayList<>());
    }
}
