package org.sami.crw.operator.map;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.Geodesy;
import org.sami.spn.value.GeoPoint;

/** What the map shows of a path that turns around what is not to be entered: from the quay north around a corner to the first point, then east. */
class WayAheadTest {
    private static final GeoPoint QUAY = GeoPoint.of(45.7, 10.72);
    private static final GeoPoint CORNER = at(0, 100);
    private static final GeoPoint FAR_CORNER = at(100, 100);
    private static final GeoPoint FIRST = at(100, 0);
    private static final GeoPoint LAST = at(200, 0);
    private static final List<GeoPoint> PATH = List.of(FIRST, LAST);
    private static final List<GeoPoint> DRIVEN = List.of(CORNER, FAR_CORNER, FIRST, LAST);

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(QUAY, eastM, northM);
    }

    private static WayAhead seenFrom(GeoPoint boat, int visited) {
        return WayAhead.of(PATH, visited, Optional.of(DRIVEN), Optional.of(boat));
    }

    @Test
    void turnsAreAheadUntilTheBoatHasPassedThem() {
        assertThat(seenFrom(QUAY, 0)).isEqualTo(new WayAhead(DRIVEN, 0));
        assertThat(seenFrom(at(0, 95), 0).behind()).isZero();
        assertThat(seenFrom(at(30, 104), 0).behind()).isEqualTo(1);
        assertThat(seenFrom(at(98, 60), 0).behind()).isEqualTo(2);
    }

    @Test
    void visitedPointsAreBehindTheBoatWithTheTurnsBeforeThem() {
        assertThat(seenFrom(at(110, 0), 1).behind()).isEqualTo(3);
        assertThat(seenFrom(LAST, 2).behind()).isEqualTo(4);
    }

    @Test
    void pathOfWhichNoTurnsAreKnownIsShownAsItIs() {
        assertThat(WayAhead.of(PATH, 1, Optional.empty(), Optional.of(QUAY))).isEqualTo(new WayAhead(PATH, 1));
        assertThat(WayAhead.of(PATH, 1, Optional.of(PATH), Optional.of(QUAY))).isEqualTo(new WayAhead(PATH, 1));
    }
}
