package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** What is said of a boat that gets nothing of an area. */
class BoatWithoutAShareTest {
    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(GeoPoint.of(45.7, 10.72), eastM, northM);
    }

    /** Its charge lasts for the way to an equal piece, and not for the one to what the other leaves. */
    @Test
    void boatAsFastAsTheOtherIsNotCalledSlow() {
        GeoArea area = new GeoArea(List.of(at(-50, -30), at(50, -30), at(50, 30), at(-50, 30)), List.of());
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        boats.put("weak", Optional.of(at(89, -88)));
        boats.put("strong", Optional.of(at(-26, -83)));

        Coverage coverage = new LawnMower()
                .cover(CoverageProblem.of(boats, area, 10)
                        .with(Ranges.out(Map.of("weak", 137.0, "strong", 2000.0), false)));

        assertThat(coverage.shares()).containsOnlyKeys("strong");
        assertThat(coverage.noWay().get("weak")).startsWith("weak has charge for 137 m");
    }
}
