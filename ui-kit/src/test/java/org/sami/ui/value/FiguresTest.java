package org.sami.ui.value;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

class FiguresTest {
    private static final GeoPath NOWHERE = new GeoPath(List.of());

    private static List<String> lines(List<? extends Value> keys) {
        Map<Value, Value> entries = new LinkedHashMap<>();
        keys.forEach(key -> entries.put(key, NOWHERE));
        return List.copyOf(Figures.of(new MapValue(entries)).lines().keySet());
    }

    @Test
    void robotsStandByTheirNamesAndAllElseInTheOrderOfTheMap() {
        assertThat(lines(List.of(new ProxyValue("bert"), new ProxyValue("carl"), new ProxyValue("anna"))))
                .containsExactly("anna", "bert", "carl");
        assertThat(lines(List.of(new TextValue("second"), new TextValue("first"))))
                .containsExactly("second", "first");
    }
}
