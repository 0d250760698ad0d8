package org.sami.crw.service.placement;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

/** Assembly and spreading next to what is to be avoided. */
class ClearOfObstaclesTest {
    private static final Water ISLAND = Water.of(AreaOfTest.CENTRE, List.of(box(25)), Optional.empty());

    @Test
    void boatsAssembleClearOfAnIslandOnWhichTheirPointLies() {
        Map<String, GeoPoint> places = new HexagonalAssembly()
                .assemble(new AssemblyProblem(boats(12), AreaOfTest.CENTRE, 10, List.of(), ISLAND));

        assertThat(places).hasSize(12);
        assertThat(places.values()).allSatisfy(place -> {
            assertThat(ISLAND.clearanceM(place)).isGreaterThanOrEqualTo(5);
            assertThat(Geodesy.distanceM(AreaOfTest.CENTRE, place)).isLessThan(60);
        });
        assertThat(places.values())
                .allSatisfy(one -> assertThat(places.values())
                        .filteredOn(other -> Geodesy.distanceM(one, other) < 9.99)
                        .containsExactly(one));
    }

    @Test
    void whereThereIsNoRoomThatIsSaid() {
        Water pond = Water.of(AreaOfTest.CENTRE, List.of(), Optional.of(box(12)));
        AssemblyProblem problem = new AssemblyProblem(boats(50), AreaOfTest.CENTRE, 10, List.of(), pond);

        assertThatThrownBy(() -> new HexagonalAssembly().assemble(problem))
                .hasMessageContaining("There is no room for 50 boats");
    }

    @Test
    void locationsAreSpreadOverTheWholeAreaClearOfTheIsland() {
        GeoArea area = box(100);

        List<GeoPoint> spread = SpreadLocations.over(area, 15, ISLAND);

        double freeM2 = 200 * 200 - 65 * 65;
        double eachM2 = 15 * 15 * Math.sqrt(3) / 2;
        assertThat((double) spread.size()).isBetween(0.85 * freeM2 / eachM2, 1.25 * freeM2 / eachM2);
        assertThat(spread).allSatisfy(one -> {
            assertThat(ISLAND.clearanceM(one)).isGreaterThanOrEqualTo(7.5);
            assertThat(spread)
                    .filteredOn(other -> Geodesy.distanceM(one, other) < 14.9)
                    .containsExactly(one);
        });
        assertThatThrownBy(() -> SpreadLocations.over(area, 0.01, ISLAND)).hasMessageContaining("more than 100000");
    }

    private static Map<String, Optional<GeoPoint>> boats(int count) {
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        for (int i = 1; i <= count; i++) {
            boats.put("boat-" + i, Optional.of(Geodesy.offset(AreaOfTest.CENTRE, 5 * i, -200)));
        }
        return boats;
    }

    private static GeoArea box(double halfM) {
        return new GeoArea(
                List.of(at(-halfM, -halfM), at(halfM, -halfM), at(halfM, halfM), at(-halfM, halfM)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }
}
