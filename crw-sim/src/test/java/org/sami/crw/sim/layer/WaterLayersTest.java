package org.sami.crw.sim.layer;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Depth and current by place, and what files of them may say. */
class WaterLayersTest {
    private static final String GRID = """
        ncols 3
        nrows 2
        xllcorner 10
        yllcorner 45
        cellsize 0.1
        NODATA_value -1
        1 2 -1
        3 4 0
        """;

    private static final String CURRENTS = "lat,lon,speed,direction\n45.0,10.0,1,90\n45.0,10.2,1,0\n";

    @ParameterizedTest
    @CsvSource({
        "45.15, 10.05, 1", // the middle of a cell
        "45.05, 10.15, 4",
        "45.10, 10.10, 2.5", // in the middle of four
        "45.15, 10.10, 1.5",
        "45.01, 10.01, 3", // between a middle and the rim
        "45.15, 10.17, 2" // next to a cell without data
    })
    void depthIsInterpolatedBetweenTheMiddlesOfCells(double latDeg, double lonDeg, double depthM) {
        assertThat(DepthGrid.parse(GRID).depthM(latDeg, lonDeg)).hasValueCloseTo(depthM, within(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"45.15, 10.25", "45.05, 10.25", "45.25, 10.05", "44.9, 10.05", "45.05, 9.9", "45.05, 10.4"})
    void thereIsNoDepthWithoutDataOnLandAndOutside(double latDeg, double lonDeg) {
        assertThat(DepthGrid.parse(GRID).depthM(latDeg, lonDeg)).isEmpty();
    }

    @Test
    void gridByMiddlesWithCellsOfTwoSidesIsTheSame() {
        String other = GRID.replace("xllcorner 10", "XLLCENTER 10.05")
                .replace("yllcorner 45", "yllcenter 45.05")
                .replace("cellsize 0.1", "dx 0.1\ndy 0.1");

        assertThat(DepthGrid.parse(other).depthM(45.1, 10.1)).hasValueCloseTo(2.5, within(1e-9));
    }

    @Test
    void currentIsThatOfAPointAtItAndTheMeanBetweenTwo() {
        CurrentField field = CurrentField.parse(CURRENTS);

        assertThat(field.at(45, 10).eastMps()).isCloseTo(1, within(1e-6));
        assertThat(field.at(45, 10).northMps()).isCloseTo(0, within(1e-6));
        assertThat(field.at(45, 10.1).eastMps()).isCloseTo(0.5, within(1e-9));
        assertThat(field.at(45, 10.1).northMps()).isCloseTo(0.5, within(1e-9));
    }

    @Test
    void whatIsWrittenIsReadAgain() {
        DepthGrid grid = DepthGrid.parse(GRID);
        CurrentField field = CurrentField.parse(CURRENTS);

        assertThat(DepthGrid.parse(grid.toString())).isEqualTo(grid);
        assertThat(CurrentField.parse(field.toString())).isEqualTo(field);
    }

    @ParameterizedTest
    @CsvSource({
        "ncols 3, ncols three, line 1: expected is one of ncols",
        "ncols 3, ncols 4, 'line 8: 4 x 2 cells need 8 depths; there are 6'",
        "ncols 3, ncols 2.5, line 6: a grid has 2 or more columns",
        "1 2 -1, 1 deep -1, line 7: 'deep' is no depth in metres",
        "xllcorner 10, xllcorner 640000, line 6: the first cell lies at 640000.05",
        "cellsize 0.1, , the head ends without cellsize",
        "cellsize 0.1, cellsize 25, line 6: cellsize is in degrees"
    })
    void gridThatMakesNoSenseIsRefusedWithItsLine(String right, String wrong, String message) {
        String text = GRID.replace(right + "\n", wrong == null ? "" : wrong + "\n");

        assertThatThrownBy(() -> DepthGrid.parse(text)).hasMessageContaining(message);
    }

    @Test
    void gridOfHeightsIsRefusedAsDepthsArePositiveDownwards() {
        String heights = GRID.replace("1 2 -1", "-2 -3 -4").replace("3 4 0", "-3 -4 0");

        assertThatThrownBy(() -> DepthGrid.parse(heights)).hasMessageContaining("positive downwards");
    }

    @Test
    void tableOfCurrentsThatMakesNoSenseIsRefusedWithItsLine() {
        assertThatThrownBy(() -> CurrentField.parse("x,y\n")).hasMessageContaining("line 1: a table of currents");
        assertThatThrownBy(() -> CurrentField.parse(CURRENTS + "45,10,1\n")).hasMessageContaining("line 4: expected");
        assertThatThrownBy(() -> CurrentField.parse(CURRENTS + "45,10,9,0\n"))
                .hasMessageContaining("line 4: a current has 0 to 5 m/s");
        assertThatThrownBy(() -> CurrentField.parse("lat,lon,speed,direction\n"))
                .hasMessageContaining("1 to 1000");
    }
}
