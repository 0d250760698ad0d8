package org.sami.crw.service.path;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.sami.crw.service.AreaOfTest;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.choice.Criterion;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.crw.service.water.Water;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPoint;

class PathsTest {
    private static final GeoPoint WEST = at(-200, 0);
    private static final GeoPoint EAST = at(200, 0);
    private final PathService service = PathService.STANDARD;

    @Test
    void noWayEntersWhatIsForbiddenAndTheShortestIsNeverLonger() {
        int ways = 0;
        int straight = 0;
        for (long seed = 1; seed <= 60; seed++) {
            Water water = Water.of(AreaOfTest.CENTRE, stars(seed, 25), Optional.empty());
            PathProblem problem = new PathProblem(WEST, EAST, water, 8);
            PathAnswer shortest = new ShortestPath().find(problem);
            PathAnswer safest = new SafestPath().find(problem);
            if (!(shortest instanceof PathAnswer.Way a) || !(safest instanceof PathAnswer.Way b)) {
                assertThat(shortest.getClass()).as("seed %s", seed).isEqualTo(safest.getClass());
                continue;
            }
            ways++;

            for (PathAnswer.Way way : List.of(a, b)) {
                List<GeoPoint> whole = new ArrayList<>(List.of(WEST));
                whole.addAll(way.points());
                assertThat(whole).last().isEqualTo(EAST);
                assertThat(samples(whole))
                        .as("seed %s", seed)
                        .allSatisfy(point -> assertThat(water.clearanceM(point)).isPositive());
                assertThat(way.clearanceM()).isEqualTo(water.clearanceM(whole));
                assertThat(way.lengthM()).isCloseTo(Geodesy.lengthM(WEST, way.points()), within(1e-9));
            }
            assertThat(a.lengthM()).as("seed %s", seed).isLessThanOrEqualTo(b.lengthM() + 1e-6);
            assertThat(b.clearanceM()).as("seed %s", seed).isGreaterThanOrEqualTo(a.clearanceM() - 1e-6);
            if (new StraightPath().find(problem) instanceof PathAnswer.Way line) {
                straight++;
                assertThat(a.lengthM()).isCloseTo(line.lengthM(), within(1e-6));
            }
        }
        assertThat(ways).isGreaterThan(40);
        assertThat(straight).isLessThan(ways);
    }

    @Test
    void wayIsFoundHoweverNearToWhatIsForbiddenItBegins() {
        GeoArea rock = new GeoArea(List.of(at(-20, -20), at(20, -20), at(20, 20), at(-20, 20)), List.of());
        Water water =
                Water.of(AreaOfTest.CENTRE, List.of(rock), Optional.empty()).drivenWith(CrossTrackError.CALM);
        for (int cm = 5; cm <= 120; cm += 5) {
            GeoPoint from = at(-18, -20 - cm / 100.0);

            Optional<List<GeoPoint>> turns = Detour.between(from, at(0, 100), water);

            assertThat(turns).as("%s cm off", cm).isPresent();
            List<GeoPoint> way = new ArrayList<>(List.of(from));
            way.addAll(turns.get());
            way.add(at(0, 100));
            assertThat(water.clearanceM(way)).as("%s cm off", cm).isPositive();
            assertThat(turns.get().size()).as("%s cm off", cm).isLessThanOrEqualTo(3);
        }
    }

    @Test
    void theShortestWayIsTheOneOfAGrid() {
        for (long seed = 1; seed <= 3; seed++) {
            Water water = Water.of(AreaOfTest.CENTRE, stars(seed, 12), Optional.empty());
            PathAnswer answer = new ShortestPath().find(new PathProblem(WEST, EAST, water, 8));

            double onGrid = new GridShortestWay(water, 5, 210).lengthM(WEST, EAST);

            assertThat(answer).as("seed %s", seed).isInstanceOf(PathAnswer.Way.class);
            assertThat(((PathAnswer.Way) answer).lengthM())
                    .as("seed %s", seed)
                    .isLessThan(onGrid + 2)
                    .isGreaterThan(onGrid * 0.93);
        }
    }

    @Test
    void theWayAroundASquareTurnsAtItsCorners() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(0, 0, 50)), Optional.empty());

        PathAnswer.Way way = (PathAnswer.Way) new ShortestPath().find(new PathProblem(WEST, EAST, water, 8));

        double ideal = 2 * Math.hypot(150, 50) + 100;
        assertThat(way.lengthM()).isCloseTo(ideal, within(0.5));
        assertThat(way.points()).hasSize(3);
    }

    @Test
    void aSafeWayKeepsItsClearanceWhereThereIsRoomAndWhatItCanWhereThereIsNone() {
        Water square = Water.of(AreaOfTest.CENTRE, List.of(box(0, 0, 50)), Optional.empty());
        Water gap = Water.of(AreaOfTest.CENTRE, List.of(box(0, 60, 57), box(0, -60, 57)), Optional.of(box(0, 0, 300)));
        Water channel = Water.of(AreaOfTest.CENTRE, List.of(wall(3, 400), wall(-400, -3)), Optional.of(box(0, 0, 300)));

        assertThat(clearance(square)).isBetween(20.0, 22.0);
        assertThat(clearance(gap)).isBetween(20.0, 22.0);
        assertThat(clearance(channel)).isBetween(2.4, 3.0);
    }

    /** The walls end 400 m away: around them the way is more than twice as long. */
    @Test
    void aGapThatIsALittleTooNarrowIsTakenAndTheClearanceKeptElsewhere() {
        List<GeoArea> walls = List.of(wall(3, 400), wall(-400, -3));
        GeoArea rock = box(-175, 10, 8);
        Water water = Water.of(AreaOfTest.CENTRE, List.of(walls.get(0), walls.get(1), rock), Optional.empty());
        PathProblem problem = new PathProblem(WEST, EAST, water, 3.1);

        PathAnswer.Way way = (PathAnswer.Way) new SafestPath().find(problem);
        PathAnswer.Way around = (PathAnswer.Way) new SafestPath().find(new PathProblem(WEST, EAST, water, 3.1, 3));

        assertThat(way.lengthM()).isLessThan(410);
        assertThat(way.clearanceM()).isGreaterThan(2.7);
        List<GeoPoint> whole = new ArrayList<>(List.of(WEST));
        whole.addAll(way.points());
        assertThat(Water.of(AreaOfTest.CENTRE, List.of(rock), Optional.empty()).clearanceM(whole))
                .isGreaterThanOrEqualTo(3.1);
        assertThat(around.clearanceM()).isGreaterThanOrEqualTo(3.1);
        assertThat(around.lengthM()).isGreaterThan(800);
    }

    /** The walls end 400 m away; 30 m before the gap lies a rock beside the way. */
    @ParameterizedTest
    @CsvSource({"1.4, 8", "1.5, 8", "2, 8", "3, 8", "5, 8", "12, 8", "1.5, 0.6", "1.8, 0.6"})
    void aNarrowGapIsPassedInItsMiddleAndTheClearanceKeptElsewhere(double widthM, double clearanceM) {
        List<GeoArea> walls = List.of(wall(-4, 400), wall(-400, -4 - widthM));
        GeoArea rock = box(-180, -5, 3);
        Water water = Water.of(AreaOfTest.CENTRE, List.of(walls.get(0), walls.get(1), rock), Optional.empty())
                .drivenWith(CrossTrackError.CALM);
        PathProblem problem = new PathProblem(at(-200, 40), at(200, 60), water, clearanceM);

        PathAnswer.Way way = (PathAnswer.Way) (clearanceM > 1 ? new SafestPath() : new ShortestPath()).find(problem);

        List<GeoPoint> whole = new ArrayList<>(List.of(problem.from()));
        whole.addAll(way.points());
        List<GeoPoint> inside = samples(whole).stream()
                .filter(point -> Math.abs(Geodesy.distanceM(at(-170, 0), point) - 170) < 130)
                .filter(point -> water.clearanceM(point) < widthM)
                .toList();
        assertThat(inside).hasSizeGreaterThan(10);
        for (GeoArea wall : walls) {
            Water alone = Water.of(AreaOfTest.CENTRE, List.of(wall), Optional.empty());
            assertThat(inside)
                    .allSatisfy(point -> assertThat(alone.clearanceM(point)).isCloseTo(widthM / 2, within(0.06)));
        }
        assertThat(Water.of(AreaOfTest.CENTRE, List.of(rock), Optional.empty()).clearanceM(whole))
                .isGreaterThanOrEqualTo(clearanceM);
        assertThat(way.points()).hasSizeLessThan(60);
        assertThat(way.clearanceM()).isCloseTo(widthM / 2, within(0.06));
    }

    private static double clearance(Water water) {
        return ((PathAnswer.Way) new SafestPath().find(new PathProblem(WEST, EAST, water, 20))).clearanceM();
    }

    @Test
    void aStartNearerThanTheClearanceIsLeftStraight() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(0, 0, 50)), Optional.empty());
        GeoPoint quay = at(-52, 0);

        PathAnswer.Way way = (PathAnswer.Way) new SafestPath().find(new PathProblem(quay, EAST, water, 20));

        assertThat(way.clearanceM()).isCloseTo(2, within(0.01));
        assertThat(water.clearanceM(way.points())).isGreaterThanOrEqualTo(20);
    }

    @Test
    void noWayIsAnAnswerThatSaysWhy() {
        Water ring = Water.of(AreaOfTest.CENTRE, ringAround(200, 0), Optional.empty());
        Water onGoal = Water.of(AreaOfTest.CENTRE, List.of(box(200, 0, 10)), Optional.empty());
        Water onStart = Water.of(AreaOfTest.CENTRE, List.of(box(-200, 0, 10)), Optional.empty());

        assertThat(reason(ring)).contains("no way").contains("all the way between");
        assertThat(reason(onGoal)).contains("the goal lies in");
        assertThat(reason(onStart)).contains("the start lies in");
    }

    private String reason(Water water) {
        PathService.Options options = service.find(new PathProblem(WEST, EAST, water, 8), Optional.empty(), 3);
        assertThat(options.ways()).isEmpty();
        return options.reason();
    }

    @Test
    void insideAnAreaWaysStayInside() {
        GeoArea horseshoe = new GeoArea(
                List.of(
                        at(-220, -50),
                        at(220, -50),
                        at(220, 150),
                        at(180, 150),
                        at(180, 0),
                        at(-180, 0),
                        at(-180, 150),
                        at(-220, 150)),
                List.of());
        Water water = Water.of(AreaOfTest.CENTRE, List.of(), Optional.of(horseshoe));

        PathAnswer.Way way =
                (PathAnswer.Way) new ShortestPath().find(new PathProblem(at(-200, 140), at(200, 140), water, 5));

        assertThat(way.points()).hasSize(3);
        assertThat(way.clearanceM()).isPositive();
    }

    @Test
    void anAreaThatCrossesItselfIsRefusedWithThePlace() {
        GeoArea bowTie = new GeoArea(List.of(at(-10, -10), at(10, 10), at(10, -10), at(-10, 10)), List.of());

        assertThatThrownBy(() -> Water.of(AreaOfTest.CENTRE, List.of(bowTie), Optional.empty()))
                .hasMessageContaining("No-go area 1")
                .hasMessageContaining("crosses")
                .hasMessageContaining("45.600000, 10.680000");
    }

    @Test
    void eachCriterionChoosesWhatIsBestByIt() {
        Water reef = Water.of(AreaOfTest.CENTRE, List.of(box(0, 30, 40)), Optional.empty());
        Water besides = Water.of(AreaOfTest.CENTRE, List.of(box(0, 45, 40)), Optional.empty());

        PathAnswer.Way efficient = first(reef, Criterion.EXECUTION_EFFICIENCY);
        PathAnswer.Way safe = first(reef, Criterion.EXECUTION_SAFETY);
        PathAnswer.Way soon = first(besides, Criterion.COMPUTATION_TIME);

        assertThat(efficient.method()).isEqualTo("Shortest path");
        assertThat(safe.method()).isEqualTo("Safest path");
        assertThat(efficient.lengthM()).isLessThan(safe.lengthM() - 1);
        assertThat(safe.clearanceM()).isGreaterThan(efficient.clearanceM() + 5);
        assertThat(soon.method()).isEqualTo("Straight path");
        assertThat(soon.legsTested())
                .isLessThan(first(reef, Criterion.EXECUTION_TIME).legsTested());
    }

    @Test
    void whereTheChosenAlgorithmFindsNoWayTheNextIsTriedAndTheReasonSaysSo() {
        Water water = Water.of(AreaOfTest.CENTRE, List.of(box(0, 0, 50)), Optional.empty());

        PathService.Options options =
                service.find(new PathProblem(WEST, EAST, water, 8), Optional.of(Criterion.COMPUTATION_TIME), 1);

        assertThat(options.ways()).extracting(PathAnswer.Way::method).containsExactly("Shortest path");
        assertThat(options.reason()).contains("Straight path found none");
    }

    private PathAnswer.Way first(Water water, Criterion criterion) {
        return service.find(new PathProblem(WEST, EAST, water, 10), Optional.of(criterion), 1)
                .ways()
                .get(0);
    }

    private static List<GeoPoint> samples(List<GeoPoint> way) {
        List<GeoPoint> samples = new ArrayList<>();
        for (int i = 1; i < way.size(); i++) {
            for (int part = 0; part <= 50; part++) {
                double t = part / 50.0;
                samples.add(GeoPoint.of(
                        way.get(i - 1).latDeg() * (1 - t) + way.get(i).latDeg() * t,
                        way.get(i - 1).lonDeg() * (1 - t) + way.get(i).lonDeg() * t));
            }
        }
        return samples;
    }

    /** Stars with concave corners, none over the two ends. */
    private static List<GeoArea> stars(long seed, int count) {
        Random random = new Random(seed);
        List<GeoArea> stars = new ArrayList<>();
        while (stars.size() < count) {
            double east = random.nextDouble() * 340 - 170;
            double north = random.nextDouble() * 300 - 150;
            stars.add(star(random, east, north));
        }
        return stars;
    }

    private static GeoArea star(Random random, double eastM, double northM) {
        List<GeoPoint> outline = new ArrayList<>();
        int points = 5 + random.nextInt(6);
        for (int i = 0; i < points; i++) {
            double radius = 8 + random.nextDouble() * 18;
            double angle = 2 * Math.PI * i / points;
            outline.add(at(eastM + radius * Math.cos(angle), northM + radius * Math.sin(angle)));
        }
        return new GeoArea(outline, List.of());
    }

    private static List<GeoArea> ringAround(double eastM, double northM) {
        return List.of(new GeoArea(
                box(eastM, northM, 60).outline(), List.of(box(eastM, northM, 40).outline())));
    }

    private static GeoArea box(double eastM, double northM, double halfM) {
        return new GeoArea(
                List.of(
                        at(eastM - halfM, northM - halfM),
                        at(eastM + halfM, northM - halfM),
                        at(eastM + halfM, northM + halfM),
                        at(eastM - halfM, northM + halfM)),
                List.of());
    }

    private static GeoArea wall(double southM, double northM) {
        return new GeoArea(List.of(at(-150, southM), at(150, southM), at(150, northM), at(-150, northM)), List.of());
    }

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(AreaOfTest.CENTRE, eastM, northM);
    }
}
