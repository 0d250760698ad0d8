package org.sami.crw.service.coverage;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;
import static org.sami.crw.service.coverage.PlainGeometry.at;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class LawnMowerTest {
    private static final int SAMPLES = 2000;
    private final LawnMower lawnMower = new LawnMower();

    @Test
    void aRectangleIsDrivenInLanesAlongItsLongSide() {
        Coverage coverage = lawnMower.cover(CoverageProblem.of(boats(1), box(0, 0, 100, 60), 10));

        assertThat(coverage.areaM2()).isCloseTo(6000, within(1.0));
        assertThat(coverage.trackM()).isCloseTo(6 * 99 + 5 * 10, within(0.5));
        assertThat(coverage.uncoveredM2()).isLessThan(0.5);
        assertThat(coverage.shares().get("boat-1").track()).hasSize(12);
    }

    @Test
    void anAreaThatIsCutInTwoIsCoveredByTheBoatsOnEachSideAndWhatNobodyReachesIsNamed() {
        GeoArea area = box(0, 0, 100, 60);
        GeoArea wall = box(0, 0, 4, 120);
        Optional<GeoArea> bay = Optional.of(box(0, 0, 120, 80));
        Map<String, Optional<GeoPoint>> both = new LinkedHashMap<>();
        both.put("west", Optional.of(at(-55, 5)));
        both.put("east", Optional.of(at(55, 20)));

        Coverage together = lawnMower.cover(new CoverageProblem(both, area, 10, List.of(wall), bay));
        Coverage alone = lawnMower.cover(
                new CoverageProblem(Map.of("west", Optional.of(at(-55, 5))), area, 10, List.of(wall), bay));

        assertThat(together.noWay()).isEmpty();
        assertThat(together.shares()).containsOnlyKeys("west", "east");
        assertThat(together.unreached()).isEmpty();
        assertThat(together.uncoveredM2()).isLessThan(10);
        assertThat(alone.shares()).containsOnlyKeys("west");
        assertThat(alone.unreached()).singleElement().satisfies(part -> {
            assertThat(part.areaM2()).isCloseTo(48 * 60, within(120.0));
            assertThat(part.near().lonDeg()).isGreaterThan(at(0, 0).lonDeg());
        });
        assertThat(alone.words()).contains("no boat can reach");
    }

    /** Every point that no track comes near is in the reported rest, which is no larger than that; no track leaves the area. */
    @Test
    void whatNoTrackComesNearIsReportedAndNoTrackLeavesTheArea() {
        double worstRest = 0;
        for (long seed = 1; seed <= 80; seed++) {
            Random random = new Random(seed * 7919);
            GeoArea area = star(random, seed % 2 == 0);
            double spacingM = 3 + random.nextDouble() * 22;
            int boats = 1 + random.nextInt(5);

            Coverage coverage = lawnMower.cover(CoverageProblem.of(boats(boats), area, spacingM));

            assertThat(coverage.shares()).as("seed %s", seed).hasSize(boats);
            assertCovered(seed, area, spacingM, coverage, random);
            assertInside(seed, area, coverage);
            worstRest = Math.max(worstRest, coverage.uncoveredM2() / coverage.areaM2());
        }
        assertThat(worstRest).isBetween(0.001, 0.3);
    }

    @Test
    void combsAndSpiralsAndNarrowBridgesAreDrivenInside() {
        List<GeoArea> areas = List.of(comb(), spiral(), bridge());
        for (GeoArea area : areas) {
            for (double spacingM : new double[] {2, 5, 11}) {
                Coverage coverage = lawnMower.cover(CoverageProblem.of(boats(3), area, spacingM));

                assertCovered(0, area, spacingM, coverage, new Random(5));
                assertInside(0, area, coverage);
                assertThat(coverage.uncoveredM2() / coverage.areaM2())
                        .as("area %s spacing %s", areas.indexOf(area), spacingM)
                        .isLessThan(0.05);
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 7, 20, 100})
    void theTrackIsDividedByLength(int boats) {
        Coverage coverage = lawnMower.cover(CoverageProblem.of(boats(boats), star(new Random(4), true), 8));
        double whole = lawnMower
                .cover(CoverageProblem.of(boats(1), star(new Random(4), true), 8))
                .trackM();

        assertThat(coverage.shares()).hasSize(boats);
        assertThat(coverage.trackM()).isCloseTo(whole, within(1e-6));
        assertThat(coverage.shares().values())
                .allSatisfy(share -> assertThat(share.trackM()).isCloseTo(whole / boats, within(1e-6)));
    }

    @Test
    void theNearerBoatGetsTheNearerShareAndDrivesItFromItsNearerEnd() {
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        boats.put("north", Optional.of(at(-60, 300)));
        boats.put("south", Optional.of(at(-60, -300)));

        Coverage coverage = lawnMower.cover(CoverageProblem.of(boats, box(0, 0, 100, 60), 10));

        assertThat(coverage.shares().get("north").track().get(0).latDeg())
                .isGreaterThan(at(0, 20).latDeg());
        assertThat(coverage.shares().get("south").track().get(0).latDeg())
                .isLessThan(at(0, -20).latDeg());
    }

    @Test
    void whatIsToBeAvoidedIsNotCountedNotEnteredAndGoneAround() {
        GeoArea area = box(0, 0, 200, 100);
        GeoArea island = box(0, 0, 40, 300);
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        boats.put("west", Optional.of(at(-300, 0)));
        boats.put("west-too", Optional.of(at(-310, 0)));

        Coverage coverage = lawnMower.cover(new CoverageProblem(boats, area, 10, List.of(island), Optional.empty()));

        assertThat(coverage.areaM2()).isCloseTo(16_000, within(5.0));
        assertThat(coverage.uncoveredM2()).isLessThan(10);
        PlainGeometry plane = new PlainGeometry(area);
        for (Map.Entry<String, CoverageShare> share : coverage.shares().entrySet()) {
            List<GeoPoint> whole =
                    new ArrayList<>(List.of(boats.get(share.getKey()).orElseThrow()));
            whole.addAll(share.getValue().path().points());
            assertThat(samples(plane, whole)).noneMatch(place -> plane.isIn(place, island));
        }
        assertThat(coverage.shares().values())
                .anyMatch(share -> !share.approach().isEmpty());
    }

    @Test
    void aBoatThatCannotGetThereIsNamedAndTheOthersShareAll() {
        GeoArea wall = new GeoArea(
                box(400, 0, 30, 30).outline(), List.of(box(400, 0, 20, 20).outline()));
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        boats.put("caught", Optional.of(at(400, 0)));
        boats.put("free", Optional.of(at(-200, 0)));
        GeoArea area = box(0, 0, 100, 60);

        Coverage coverage = lawnMower.cover(new CoverageProblem(boats, area, 10, List.of(wall), Optional.empty()));
        Coverage alone = lawnMower.cover(
                new CoverageProblem(Map.of("caught", boats.get("caught")), area, 10, List.of(wall), Optional.empty()));

        assertThat(coverage.noWay()).containsOnlyKeys("caught");
        assertThat(coverage.noWay().get("caught")).contains("all the way between");
        assertThat(coverage.shares()).containsOnlyKeys("free");
        assertThat(coverage.uncoveredM2()).isLessThan(1);
        assertThat(alone.shares()).isEmpty();
        assertThat(alone.uncoveredM2()).isCloseTo(alone.areaM2(), within(1e-6));
    }

    @Test
    void aBoatThatLiesInANoGoAreaLeavesItAndGetsItsShare() {
        GeoArea quay = box(0, -45, 40, 20);
        Map<String, Optional<GeoPoint>> inside = Map.of("boat-1", Optional.of(at(0, -45)));

        for (CrossTrackError error : List.of(CrossTrackError.NONE, CrossTrackError.CALM)) {
            Coverage coverage = lawnMower.cover(
                    new CoverageProblem(inside, box(0, 0, 100, 60), 10, List.of(quay), Optional.empty(), error));

            assertThat(coverage.noWay()).isEmpty();
            assertThat(coverage.shares()).containsOnlyKeys("boat-1");
            assertThat(coverage.uncoveredM2()).isLessThan(10);
        }
    }

    @Test
    void aNarrowStripGetsOneLaneAndTheRestIsCounted() {
        Coverage strip = lawnMower.cover(CoverageProblem.of(boats(1), box(0, 0, 100, 1), 10));
        Coverage hair = lawnMower.cover(CoverageProblem.of(boats(1), box(0, 0, 50, 0.01), 10));

        assertThat(strip.trackM()).isCloseTo(100, within(1.1));
        assertThat(strip.uncoveredM2()).isLessThan(0.01);
        assertThat(hair.uncoveredM2()).isLessThan(0.01);
    }

    @Test
    void whatCannotBeCoveredIsRefusedWithTheReason() {
        GeoArea bow = new GeoArea(List.of(at(0, 0), at(10, 10), at(10, 0), at(0, 10)), List.of());
        GeoArea area = box(0, 0, 20, 20);

        assertThatThrownBy(() -> lawnMower.cover(CoverageProblem.of(boats(1), bow, 1)))
                .hasMessageContaining("The area is no simple polygon: it crosses or touches itself at");
        assertThatThrownBy(() -> lawnMower.cover(
                        new CoverageProblem(boats(1), area, 1, List.of(box(0, 0, 30, 30)), Optional.empty())))
                .hasMessage("Nothing of the area may be entered");
        assertThatThrownBy(() -> CoverageProblem.of(boats(1), area, 0)).hasMessageContaining("spacing is at least");
        assertThatThrownBy(() -> CoverageProblem.of(Map.of(), area, 1)).hasMessageContaining("no boat");
    }

    private static void assertCovered(long seed, GeoArea area, double spacingM, Coverage coverage, Random random) {
        PlainGeometry plane = new PlainGeometry(area);
        List<double[]> corners = area.outline().stream().map(plane::place).toList();
        double west = corners.stream().mapToDouble(c -> c[0]).min().orElseThrow();
        double east = corners.stream().mapToDouble(c -> c[0]).max().orElseThrow();
        double south = corners.stream().mapToDouble(c -> c[1]).min().orElseThrow();
        double north = corners.stream().mapToDouble(c -> c[1]).max().orElseThrow();
        int inside = 0;
        int far = 0;
        for (int i = 0; i < SAMPLES; i++) {
            double[] place = {west + random.nextDouble() * (east - west), south + random.nextDouble() * (north - south)
            };
            if (plane.isIn(place, area)) {
                inside++;
                double distanceM = coverage.shares().values().stream()
                        .mapToDouble(share -> plane.distanceM(place, share.track()))
                        .min()
                        .orElseThrow();
                boolean reported = coverage.rest().stream().anyMatch(rest -> plane.isIn(place, rest));
                if (distanceM > spacingM / 2 + 1e-6) {
                    far++;
                    assertThat(reported)
                            .as("seed %s: %.3f m from the track", seed, distanceM)
                            .isTrue();
                } else if (distanceM < spacingM / 2 * 0.998) {
                    assertThat(reported)
                            .as("seed %s: %.3f m from the track", seed, distanceM)
                            .isFalse();
                }
            }
        }
        assertThat((double) far / inside)
                .as("seed %s", seed)
                .isCloseTo(coverage.uncoveredM2() / coverage.areaM2(), within(0.04));
    }

    private static void assertInside(long seed, GeoArea area, Coverage coverage) {
        PlainGeometry plane = new PlainGeometry(area);
        coverage.shares()
                .values()
                .forEach(share -> assertThat(samples(plane, share.track()))
                        .as("seed %s", seed)
                        .allMatch(place -> plane.isIn(place, area)));
    }

    private static List<double[]> samples(PlainGeometry plane, List<GeoPoint> track) {
        List<double[]> samples = new ArrayList<>();
        for (int i = 1; i < track.size(); i++) {
            double[] a = plane.place(track.get(i - 1));
            double[] b = plane.place(track.get(i));
            for (int part = 0; part <= 12; part++) {
                samples.add(new double[] {a[0] + (b[0] - a[0]) * part / 12, a[1] + (b[1] - a[1]) * part / 12});
            }
        }
        return samples;
    }

    private static Map<String, Optional<GeoPoint>> boats(int count) {
        Map<String, Optional<GeoPoint>> boats = new LinkedHashMap<>();
        for (int i = 1; i <= count; i++) {
            boats.put("boat-" + i, i % 4 == 3 ? Optional.empty() : Optional.of(at(-200, 7 * i)));
        }
        return boats;
    }

    /** Concave, and every second one with a hole. */
    private static GeoArea star(Random random, boolean holed) {
        List<List<GeoPoint>> holes = holed ? List.of(ring(random, 10, 35)) : List.of();
        return new GeoArea(ring(random, 40, 130), holes);
    }

    private static List<GeoPoint> ring(Random random, double leastM, double mostM) {
        int corners = 5 + random.nextInt(20);
        double turn = random.nextDouble() * 2 * Math.PI;
        List<GeoPoint> ring = new ArrayList<>();
        for (int i = 0; i < corners; i++) {
            double radiusM = leastM + random.nextDouble() * (mostM - leastM);
            double angle = turn + 2 * Math.PI * i / corners;
            ring.add(at(radiusM * Math.cos(angle), radiusM * Math.sin(angle)));
        }
        return ring;
    }

    private static GeoArea box(double eastM, double northM, double widthM, double heightM) {
        double w = widthM / 2;
        double h = heightM / 2;
        return area(eastM - w, northM - h, eastM + w, northM - h, eastM + w, northM + h, eastM - w, northM + h);
    }

    private static GeoArea comb() {
        return area(
                0, 0, 100, 0, 100, 80, 85, 80, 85, 20, 70, 20, 70, 80, 55, 80, 55, 20, 40, 20, 40, 80, 25, 80, 25, 20,
                15, 20, 15, 80, 0, 80);
    }

    private static GeoArea spiral() {
        return area(0, 0, 100, 0, 100, 100, 20, 100, 20, 40, 60, 40, 60, 60, 40, 60, 40, 80, 80, 80, 80, 20, 0, 20);
    }

    /** Two squares that a bridge joins which is narrower than the lanes are apart. */
    private static GeoArea bridge() {
        return area(0, 0, 50, 0, 50, 24, 90, 24, 90, 0, 140, 0, 140, 50, 90, 50, 90, 25.5, 50, 25.5, 50, 50, 0, 50);
    }

    private static GeoArea area(double... eastNorth) {
        List<GeoPoint> points = new ArrayList<>();
        for (int i = 0; i < eastNorth.length; i += 2) {
            points.add(at(eastNorth[i], eastNorth[i + 1]));
        }
        return new GeoArea(points, List.of());
    }

    @Test
    void boatThatIsSoSlowThatItGetsNothingIsNotSaidToHaveTooLittleCharge() {
        Coverage coverage = lawnMower.cover(
                CoverageProblem.of(boats(2), box(0, 0, 100, 60), 10).at(Map.of("boat-1", 2.0, "boat-2", 0.001)));

        assertThat(coverage.shares()).containsOnlyKeys("boat-1");
        assertThat(coverage.noWay())
                .containsExactly(Map.entry("boat-2", "boat-2 is so slow that the others explore its part sooner"));
    }
}
