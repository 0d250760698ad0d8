package org.sami.crw.service.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.allocation.LeastSumAssignment;
import org.sami.spn.value.GeoPoint;

class HexagonalAssemblyTest {
    private final AssemblyAlgorithm assembly = new HexagonalAssembly();

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 7, 8, 25, 250})
    void givesEachBoatALocationOfItsOwnAtTheSpacing(int count) {
        Map<String, Optional<GeoPoint>> boats = known(new AreaOfTest(count).boats(count));

        Map<String, GeoPoint> places = assembly.assemble(problem(boats, List.of()));

        assertThat(places.keySet()).containsExactlyElementsOf(boats.keySet());
        assertSpacing(List.copyOf(places.values()), 10);
        double radiusM = 10 * Math.ceil(Math.sqrt(count / 3.0)) + 0.01;
        assertThat(places.values())
                .allSatisfy(place ->
                        assertThat(Geodesy.distanceM(AreaOfTest.CENTRE, place)).isLessThanOrEqualTo(radiusM));
    }

    @Test
    void oneBoatAssemblesAtThePointItself() {
        Map<String, GeoPoint> places = assembly.assemble(problem(known(new AreaOfTest(1).boats(1)), List.of()));

        assertThat(places).containsEntry("boat-1", AreaOfTest.CENTRE);
    }

    @Test
    void keepsAwayFromWhatIsTaken() {
        List<GeoPoint> taken = new ArrayList<>(List.of(AreaOfTest.CENTRE, Geodesy.offset(AreaOfTest.CENTRE, 13, 4)));

        Map<String, GeoPoint> places = assembly.assemble(problem(known(new AreaOfTest(1).boats(6)), taken));

        taken.addAll(places.values());
        assertSpacing(taken, 10);
    }

    @Test
    void aBoatWhosePositionIsUnknownGetsWhatTheOthersLeave() {
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        boats.put("unknown", Optional.empty());
        boats.put("here", Optional.of(AreaOfTest.CENTRE));

        Map<String, GeoPoint> places = assembly.assemble(problem(boats, List.of()));

        assertThat(places).containsEntry("here", AreaOfTest.CENTRE);
        assertThat(places.get("unknown")).isNotEqualTo(AreaOfTest.CENTRE);
    }

    @Test
    void noOtherAssignmentHasASmallerSumOfDistances() {
        for (long seed = 1; seed <= 50; seed++) {
            double[][] costs = costs(new Random(seed), 5, 6);

            int[] columns = LeastSumAssignment.of(costs);

            double sum = 0;
            for (int row = 0; row < columns.length; row++) {
                sum += costs[row][columns[row]];
            }
            assertThat(sum)
                    .as("seed %s", seed)
                    .isCloseTo(least(costs, 0, 0), org.assertj.core.data.Offset.offset(1e-9));
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {0, -1, Double.NaN, Double.POSITIVE_INFINITY})
    void aSpacingThatIsNoneIsRefused(double spacingM) {
        assertThatThrownBy(() -> new AssemblyProblem(Map.of(), AreaOfTest.CENTRE, spacingM, List.of()))
                .hasMessageContaining("" + spacingM);
    }

    private static AssemblyProblem problem(Map<String, Optional<GeoPoint>> boats, List<GeoPoint> taken) {
        return new AssemblyProblem(boats, AreaOfTest.CENTRE, 10, taken);
    }

    private static Map<String, Optional<GeoPoint>> known(Map<String, GeoPoint> boats) {
        Map<String, Optional<GeoPoint>> known = new LinkedHashMap<>();
        boats.forEach((boat, at) -> known.put(boat, Optional.of(at)));
        return known;
    }

    private static void assertSpacing(List<GeoPoint> points, double spacingM) {
        for (int i = 0; i < points.size(); i++) {
            for (int j = 0; j < i; j++) {
                assertThat(Geodesy.distanceM(points.get(i), points.get(j))).isGreaterThan(spacingM * 0.999);
            }
        }
    }

    private static double[][] costs(Random random, int rows, int columns) {
        double[][] costs = new double[rows][columns];
        for (double[] row : costs) {
            for (int column = 0; column < columns; column++) {
                row[column] = random.nextInt(20);
            }
        }
        return costs;
    }

    private static double least(double[][] costs, int row, int usedColumns) {
        if (row == costs.length) {
            return 0;
        }
        double least = Double.POSITIVE_INFINITY;
        for (int column = 0; column < costs[row].length; column++) {
            if ((usedColumns & 1 << column) == 0) {
                least = Math.min(least, costs[row][column] + least(costs, row + 1, usedColumns | 1 << column));
            }
        }
        return least;
    }
}
