package org.sami.crw.operator.map;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.sami.spn.value.GeoPoint;

class PlacesInTextTest {
    @Test
    void placesOfAQuestionAreFoundInTheirOrder() {
        assertThat(PlacesInText.of(
                        "8438 m² stay unexplored, most near 25.36159,51.52857. no boat can reach 2801 m² near"
                                + " -45.69981,-110.72012; and 25.36159,51.52857 again"))
                .containsExactly(GeoPoint.of(25.36159, 51.52857), GeoPoint.of(-45.69981, -110.72012));
    }

    @Test
    void numbersThatAreNoPlaceAreNone() {
        assertThat(PlacesInText.of(
                        "Exploring 183982 m² in 4124 m of track, for 5 boats at most 1166 m; 8437.8 m² (4.59 %)"))
                .isEmpty();
        assertThat(PlacesInText.of("at 91.00000,10.00000 or 10.123.45678,10.00000"))
                .isEmpty();
    }
}
