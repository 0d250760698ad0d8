package org.sami.spn.analysis;

import static org.assertj.core.api.Assertions.assertThat;
import static org.sami.spn.testing.NetBuilder.project;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import org.assertj.core.groups.Tuple;
import org.junit.jupiter.api.Test;
import org.sami.spn.finding.Finding;
import org.sami.spn.model.FieldSource;
import org.sami.spn.model.VariableSpec;
import org.sami.spn.testing.NetBuilder;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.Value;
import org.sami.spn.value.ValueType;
import org.sami.spn.vocabulary.Direction;
import org.sami.spn.vocabulary.EventRole;
import org.sami.spn.vocabulary.EventType;
import org.sami.spn.vocabulary.FieldLimits;
import org.sami.spn.vocabulary.FieldType;
import org.sami.spn.vocabulary.Geography;
import org.sami.spn.vocabulary.GeographyMark;
import org.sami.spn.vocabulary.TokenNeed;
import org.sami.spn.vocabulary.Vocabulary;

/** What the checks doubt of locations and ways that are known before a run. */
class GeographyChecksTest {
    private static final Set<String> CODES =
            Set.of("W-FAR-AWAY", "W-SWAPPED", "W-AVOIDED", "W-OUTSIDE", "W-BEYOND-RANGE");

    private static final ValueType POINTS = new ValueType.ListOf(ValueType.Simple.POINT);
    private static final ValueType PATHS = new ValueType.MapOf(ValueType.Simple.PROXY, ValueType.Simple.PATH);
    private static final Vocabulary WORDS = words(Optional.of(new Geography(5000, 3500)));

    private static Vocabulary words(Optional<Geography> geography) {
        Vocabulary base = CheckWords.WORDS;
        List<EventType> events = new ArrayList<>(base.events().values());
        events.add(new EventType(
                "Visit",
                List.of(),
                Direction.OUTPUT,
                List.of(
                        field("locations", POINTS, Optional.empty()),
                        field("paths", PATHS, Optional.empty()),
                        field("avoid", new ValueType.ListOf(ValueType.Simple.AREA), Optional.of(GeographyMark.AVOID)),
                        field("within", ValueType.Simple.AREA, Optional.of(GeographyMark.WITHIN)),
                        field("area", ValueType.Simple.AREA, Optional.of(GeographyMark.LANES)),
                        field("spacing", ValueType.Simple.REAL, Optional.of(GeographyMark.LANE_SPACING))),
                TokenNeed.NONE,
                List.of(),
                EventRole.NONE,
                Set.of(),
                Optional.empty(),
                "Visit",
                ""));
        return new Vocabulary(
                base.domain(),
                List.copyOf(base.types().values()),
                events,
                List.copyOf(base.markups().values()),
                List.copyOf(base.taskClasses().values()),
                geography,
                Map.of());
    }

    private static FieldType field(String name, ValueType type, Optional<GeographyMark> mark) {
        return new FieldType(name, type, "", false, Optional.empty(), "", mark, FieldLimits.NONE);
    }

    /** A point so many metres north and east of a quay in Italy. */
    private static GeoPoint at(double northM, double eastM) {
        return GeoPoint.of(45.6 + northM / 111_195, 10.68 + eastM / 77_800);
    }

    private static ListValue list(Value... items) {
        return new ListValue(List.of(items));
    }

    private static GeoArea square(double northM, double eastM, double sideM) {
        return new GeoArea(
                List.of(
                        at(northM, eastM),
                        at(northM + sideM, eastM),
                        at(northM + sideM, eastM + sideM),
                        at(northM, eastM + sideM)),
                List.of());
    }

    private static FieldSource fixed(Value value) {
        return new FieldSource.Fixed(value);
    }

    private static NetBuilder visit(Map<String, FieldSource> fields) {
        return new NetBuilder("plan")
                .start("start")
                .end("end")
                .output("start", "Visit", fields, Map.of())
                .transition("t")
                .in("start", "t", "generic >= 1")
                .out("t", "end", "take all any");
    }

    private static List<Finding> check(NetBuilder net) {
        return PlanChecks.check(project(net.build()), WORDS).stream()
                .filter(GeographyChecksTest::isOfGeography)
                .toList();
    }

    private static boolean isOfGeography(Finding finding) {
        return CODES.contains(finding.code());
    }

    private static void assertOnly(List<Finding> findings, String code, String pointer, String... words) {
        assertThat(findings).singleElement().satisfies(finding -> {
            assertThat(finding.code()).isEqualTo(code);
            assertThat(finding.isError()).isFalse();
            assertThat(finding.pointer()).isEqualTo(pointer);
            assertThat(finding.message()).contains(words);
        });
    }

    /** For each code a plan that must be found, and one like it that must pass without that finding. */
    static List<PlanCheckCase> pairs() {
        ListValue far = list(at(0, 0), at(100, 0), at(200, 50), at(50_000, 0));
        ListValue near = list(at(0, 0), at(100, 0), at(200, 50), at(3000, 0));
        GeoPoint right = at(300, 0);
        ListValue swapped = list(at(0, 0), GeoPoint.of(right.lonDeg(), right.latDeg()), at(200, 50));
        FieldSource two = fixed(list(at(0, 0), at(150, 150)));
        FieldSource there = fixed(list(square(100, 100, 100)));
        FieldSource elsewhere = fixed(list(square(300, 300, 100)));
        return List.of(
                pair("W-FAR-AWAY", Map.of("locations", fixed(far)), Map.of("locations", fixed(near))),
                pair("W-SWAPPED", Map.of("locations", fixed(swapped)), Map.of("locations", fixed(near))),
                pair(
                        "W-AVOIDED",
                        Map.of("locations", two, "avoid", there),
                        Map.of("locations", two, "avoid", elsewhere)),
                pair(
                        "W-OUTSIDE",
                        Map.of("locations", two, "within", fixed(square(-10, -10, 100))),
                        Map.of("locations", two, "within", fixed(square(-10, -10, 200)))),
                pair("W-BEYOND-RANGE", lanes(50), lanes(500)));
    }

    private static Map<String, FieldSource> lanes(double spacingM) {
        return Map.of("area", fixed(square(0, 0, 1000)), "spacing", fixed(new RealValue(spacingM)));
    }

    private static PlanCheckCase pair(String code, Map<String, FieldSource> bad, Map<String, FieldSource> good) {
        return new PlanCheckCase(
                code, project(visit(bad).build()), project(visit(good).build()), WORDS);
    }

    @Test
    void locationsThatLieTogetherAreNotDoubted() {
        assertThat(check(visit(Map.of("locations", fixed(list(at(0, 0), at(2000, 100), at(-1500, 3000)))))))
                .isEmpty();
    }

    @Test
    void locationFarFromTheOthersIsNamedWithItsDistance() {
        ListValue points = list(at(0, 0), at(100, 0), at(200, 50), at(50_000, 0));

        assertOnly(
                check(visit(Map.of("locations", fixed(points)))),
                "W-FAR-AWAY",
                "/plans/0/places/0/outputs/0/fields/locations/value/3",
                "locations of Visit at the place \"start\" is ",
                "49.9 km",
                "5.0 km");
    }

    @Test
    void locationWithLatitudeAndLongitudeSwappedIsSaidToBeSo() {
        GeoPoint right = at(300, 0);
        ListValue points = list(at(0, 0), GeoPoint.of(right.lonDeg(), right.latDeg()), at(200, 50));

        assertOnly(
                check(visit(Map.of("locations", fixed(points)))),
                "W-SWAPPED",
                "/plans/0/places/0/outputs/0/fields/locations/value/1",
                "are they swapped?");
    }

    @Test
    void globalThatThePlanReadsIsHeldAgainstItsOwnLocations() {
        NetBuilder net = visit(Map.of(
                "locations", fixed(list(at(0, 0), at(100, 0))), "within", new FieldSource.FromVariable("@lake")));
        VariableSpec lake = new VariableSpec("@lake", ValueType.Simple.AREA, Optional.of(square(80_000, 0, 500)));
        VariableSpec unread = new VariableSpec("@sea", ValueType.Simple.POINT, Optional.of(GeoPoint.of(-40, 170)));

        List<Finding> findings = PlanChecks.check(project(List.of(unread, lake), net.build()), WORDS);

        assertThat(findings)
                .filteredOn(GeographyChecksTest::isOfGeography)
                .extracting(Finding::code, Finding::pointer)
                .containsExactly(
                        Tuple.tuple("W-FAR-AWAY", "/globals/1/initial/outline/0"),
                        Tuple.tuple("W-OUTSIDE", "/plans/0/places/0/outputs/0/fields/locations/value/0"));
    }

    @Test
    void locationInAnAreaToBeAvoidedIsNamed() {
        NetBuilder net = visit(
                Map.of("locations", fixed(list(at(0, 0), at(150, 150))), "avoid", fixed(list(square(100, 100, 100)))));

        assertOnly(check(net), "W-AVOIDED", "/plans/0/places/0/outputs/0/fields/locations/value/1", "avoid", "move it");
    }

    @Test
    void holeOfAnAreaIsNotAvoided() {
        GeoArea ring = new GeoArea(
                square(0, 0, 300).outline(), List.of(square(100, 100, 100).outline()));

        assertThat(check(visit(Map.of("locations", fixed(list(at(150, 150))), "avoid", fixed(list(ring))))))
                .isEmpty();
    }

    @Test
    void locationOutsideTheAreaThatIsNotLeftIsNamed() {
        NetBuilder net =
                visit(Map.of("locations", fixed(list(at(50, 50), at(-50, 50))), "within", fixed(square(0, 0, 100))));

        assertOnly(check(net), "W-OUTSIDE", "/plans/0/places/0/outputs/0/fields/locations/value/1", "outside");
    }

    @Test
    void pathLongerThanACharge() {
        GeoPath there = new GeoPath(List.of(at(0, 0), at(1900, 0), at(0, 0)));
        MapValue paths = new MapValue(Map.of(new ProxyValue("b1"), there));

        assertOnly(
                check(visit(Map.of("paths", fixed(paths)))),
                "W-BEYOND-RANGE",
                "/plans/0/places/0/outputs/0/fields/paths/value",
                "3.8 km",
                "3.5 km");
        assertThat(check(visit(Map.of(
                        "paths",
                        fixed(new MapValue(
                                Map.of(new ProxyValue("b1"), new GeoPath(List.of(at(0, 0), at(1900, 0))))))))))
                .isEmpty();
    }

    @Test
    void lanesOfAnExplorationLongerThanAChargeSayHowManyChargesTheyTake() {
        NetBuilder net = visit(Map.of("area", fixed(square(0, 0, 1000)), "spacing", fixed(new RealValue(50))));

        assertOnly(
                check(net),
                "W-BEYOND-RANGE",
                "/plans/0/places/0/outputs/0/fields/area/value",
                "20.0 km",
                "at least 6 robots or charges");
    }

    @Test
    void domainThatSaysNothingOfDistancesIsNotChecked() {
        NetBuilder net = visit(Map.of("locations", fixed(list(at(0, 0), at(90_000, 0)))));

        assertThat(PlanChecks.check(project(net.build()), words(Optional.empty())))
                .noneMatch(GeographyChecksTest::isOfGeography);
    }
}
