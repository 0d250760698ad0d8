package org.sami.crw.sim.run.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.server.vehicle.LocalFrame;
import org.sami.crw.report.DepthsPart.DepthCell;

/** The squares of a map of depths: means of readings, and what lies between them. */
class DepthSquaresTest {
    private final DepthSquares squares = new DepthSquares();

    private List<DepthCell> cells() {
        return squares.cells(new LocalFrame(45.7, 10.72));
    }

    @Test
    void aSquareHasTheMeanOfItsReadings() {
        squares.add(1, 1, 4);
        squares.add(4, 4, 6);

        assertThat(cells()).singleElement().satisfies(cell -> {
            assertThat(cell.depthM()).isEqualTo(5);
            assertThat(cell.readings()).isEqualTo(2);
            assertThat(cell.middle().eastM()).isEqualTo(2.5);
            assertThat(cell.middle().northM()).isEqualTo(2.5);
        });
    }

    @Test
    void aGapBetweenTwoSquaresIsFilledAndSaysSo() {
        squares.add(2, -12, 4);
        squares.add(2, -2, 8);

        assertThat(cells()).hasSize(3).anySatisfy(cell -> {
            assertThat(cell.readings()).isZero();
            assertThat(cell.depthM()).isCloseTo(6, within(1e-9));
            assertThat(cell.middle().northM()).isEqualTo(-7.5);
        });
    }

    @Test
    void lanesOf20MetresLeaveNoGapAndNothingIsSaidOutsideThem() {
        for (double alongM = 0; alongM < 100; alongM += 5) {
            squares.add(alongM, 0, 4);
            squares.add(alongM, 20, 8);
        }

        assertThat(cells())
                .hasSize(20 * 5)
                .allMatch(cell -> cell.middle().northM() > 0 && cell.middle().northM() < 25);
    }

    @Test
    void nothingIsSaidBesideMeasuredSquaresOrFarFromThem() {
        squares.add(0, 0, 4);
        squares.add(100, 0, 8);
        squares.add(100, 6, 8);

        assertThat(cells()).hasSize(3).allMatch(cell -> cell.readings() > 0);
    }
}
