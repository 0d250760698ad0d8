package org.sami.crw.service.water;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.atomic.AtomicInteger;
import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPoint;

/** What is computed from a water's forbidden areas is computed once for all boats in it. */
class DerivedOnceTest {
    private final AtomicInteger computed = new AtomicInteger();

    @Test
    void boatsOfOtherErrorsShareIt() {
        Water water = Water.open(GeoPoint.of(45.7, 10.72));

        assertThat(numbered(water, "graph")).isEqualTo(1);
        assertThat(numbered(water, "graph")).isEqualTo(1);
        assertThat(numbered(water.drivenWith(CrossTrackError.of(1.4, 0.2)), "graph"))
                .isEqualTo(1);
        assertThat(numbered(water, "other")).isEqualTo(2);
    }

    @Test
    void otherWaterHasItsOwn() {
        GeoPoint origin = GeoPoint.of(45.7, 10.72);

        assertThat(numbered(Water.open(origin), "graph")).isEqualTo(1);
        assertThat(numbered(Water.open(origin), "graph")).isEqualTo(2);
    }

    private int numbered(Water water, String key) {
        return water.derived(key, Integer.class, computed::incrementAndGet);
    }
}
