package org.sami.crw.event;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.RecordValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

class AllocationTest {
    @Test
    void becomesAValueAndComesBackInTheSameOrder() {
        Map<String, GeoPath> paths = new LinkedHashMap<>();
        paths.put("zeta", new GeoPath(List.of(GeoPoint.of(45, 10), GeoPoint.of(45.001, 10))));
        paths.put("alpha", new GeoPath(List.of()));
        Allocation allocation = new Allocation(paths, 111.13, 111.13, "by hand");

        Allocation read = Allocation.of(allocation.toValue());

        assertThat(read).isEqualTo(allocation);
        assertThat(read.paths().keySet()).containsExactly("zeta", "alpha");
    }

    @Test
    void refusesOtherValues() {
        assertThatThrownBy(() -> Allocation.of(new TextValue("boat-1"))).hasMessageContaining("boat-1");
        assertThatThrownBy(() -> Allocation.of(new RecordValue("Allocation", Map.of())))
                .hasMessageContaining("paths");
    }

    @Test
    void aMapByBoatHasBoatsAsKeysAndTheRightValues() {
        Value byText = new MapValue(Map.of(new TextValue("boat-1"), GeoPoint.of(1, 2)));
        Value ofNumbers = ProxyMaps.toValue(Map.of("boat-1", new RealValue(3)));

        assertThatThrownBy(() -> ProxyMaps.read(byText, GeoPoint.class)).hasMessageContaining("Not a map from boats");
        assertThatThrownBy(() -> ProxyMaps.read(ofNumbers, GeoPoint.class)).hasMessageContaining("GeoPoint");
        assertThatThrownBy(() -> ProxyMaps.read(new RealValue(1), GeoPoint.class))
                .hasMessageContaining("Not a map");
    }
}
