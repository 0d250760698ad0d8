package org.sami.crw.judgement;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.sami.boat.link.BoatCapabilities;
import org.sami.crw.area.OperatingArea;
import org.sami.crw.handler.motion.WayLimits;
import org.sami.crw.handler.planning.CrwServices;
import org.sami.crw.service.Geodesy;
import org.sami.crw.service.reach.Charge;
import org.sami.crw.service.water.CrossTrackError;
import org.sami.session.api.DraftAnswer;
import org.sami.session.api.Judgement;
import org.sami.spn.protocol.Question;
import org.sami.spn.value.GeoArea;
import org.sami.spn.value.GeoPath;
import org.sami.spn.value.GeoPoint;
import org.sami.spn.value.IntegerValue;
import org.sami.spn.value.ListValue;
import org.sami.spn.value.MapValue;
import org.sami.spn.value.ProxyValue;
import org.sami.spn.value.RealValue;
import org.sami.spn.value.TextValue;
import org.sami.spn.value.Value;

/** A bay of 1000 by 1000 m with a no-go area of 200 by 200 m in its south-west corner; 1 % of charge takes a boat 35 m. */
class AnswerJudgeTest {
    private static final GeoPoint CORNER = GeoPoint.of(45.4, 10.9);
    private static final GeoArea BAY = box(0, 0, 1000, 1000);
    private static final GeoArea SHOAL = box(0, 0, 200, 200);

    private static GeoPoint at(double eastM, double northM) {
        return Geodesy.offset(CORNER, eastM, northM);
    }

    private static GeoArea box(double west, double south, double east, double north) {
        return new GeoArea(List.of(at(west, south), at(west, north), at(east, north), at(east, south)), List.of());
    }

    private static JudgedBoat boat(String name, double percent) {
        return boat(name, percent, 0);
    }

    private static JudgedBoat boat(String name, double percent, double turningRadiusM) {
        return new JudgedBoat(
                name,
                Optional.of(at(300, 500)),
                Optional.of(Charge.usual(percent)),
                Optional.of(at(300, 500)),
                CrossTrackError.NONE,
                1.5,
                turningRadiusM,
                BoatCapabilities.UNKNOWN);
    }

    private static JudgedQuestion asks(Question question, JudgedRequest... requests) {
        return new JudgedQuestion(
                question,
                List.of(requests),
                List.of(),
                new WayLimits(List.of(SHOAL), Optional.empty()),
                new OperatingArea(Optional.of(BAY), List.of(SHOAL), false),
                false,
                List.of("anna", "bert"));
    }

    /** A plan that explores the area that is given, in lanes 50 m apart. */
    private static JudgedRequest exploring(boolean within) {
        Map<String, Value> known = new LinkedHashMap<>();
        known.put("spacing", new RealValue(50));
        if (within) {
            known.put("within", BAY);
        }
        return new JudgedRequest("ProxyExploreArea", known, Map.of("area", "area"));
    }

    private static Judgement judge(JudgedQuestion question, String key, Value value, JudgedBoat... boats) {
        return new AnswerJudge(CrwServices.STANDARD)
                .judge(question, List.of(boats), DraftAnswer.of(Map.of(key, value)));
    }

    private static final Question FILL_IN = new Question.FillIn(List.of());

    @Test
    void whatOfAnAreaIsOutsideTheFenceAndLeftOutIsSaid() {
        Judgement judged = judge(asks(FILL_IN, exploring(true)), "area", box(700, 400, 1154, 700));

        assertThat(judged.doubts()).containsExactly("34 % of the area is outside the fence and will be left out");
        assertThat(judged.refusal()).isEmpty();
    }

    @Test
    void whereThePlanKeepsBoatsNotInThatIsSaidToo() {
        assertThat(judge(asks(FILL_IN, exploring(false)), "area", box(700, 400, 1154, 700))
                        .doubts())
                .containsExactly("34 % of the area is outside the fence, and boats will be sent there");
    }

    @Test
    void anAreaThatIsWhollyOutsideIsRefused() {
        assertThat(judge(asks(FILL_IN, exploring(true)), "area", box(1100, 0, 1200, 100))
                        .refusal())
                .contains("The whole area is outside the fence: nothing of it is left");
    }

    @Test
    void whatOfAnAreaLiesInANoGoAreaIsSaid() {
        assertThat(judge(asks(FILL_IN, exploring(true)), "area", box(100, 100, 300, 300))
                        .doubts())
                .containsExactly("25 % of the area lies in no-go areas and will be left out");
        assertThat(judge(asks(FILL_IN, exploring(true)), "area", box(50, 50, 150, 150))
                        .refusal())
                .contains("Nothing of the area is left without what lies in no-go areas");
    }

    @Test
    void anAreaThatIsDrawnAlongTheFenceIsNotSpokenOf() {
        assertThat(judge(asks(FILL_IN, exploring(true)), "area", box(700, 400, 1000.05, 700))
                        .doubts())
                .isEmpty();
    }

    @Test
    void anAreaThatCrossesItselfIsRefused() {
        GeoArea crossed = new GeoArea(List.of(at(300, 300), at(400, 400), at(400, 300), at(300, 400)), List.of());

        assertThat(judge(asks(FILL_IN, exploring(true)), "area", crossed).refusal())
                .hasValueSatisfying(words -> assertThat(words).contains("crosses or touches itself"));
    }

    @Test
    void theFenceItselfIsNoWork() {
        assertThat(judge(asks(FILL_IN), "@water", box(0, 0, 2000, 2000)).remarks())
                .isEmpty();
    }

    @Test
    void placesInNoGoAreasAndOutsideTheFenceAreCounted() {
        ListValue places =
                new ListValue(List.of(at(100, 150), at(500, 500), at(1100, 500), at(1200, 500), at(1300, 500)));

        assertThat(judge(asks(FILL_IN), "locations", places).doubts())
                .containsExactly(
                        "Place 1 of 5 lies 50.0 m inside a no-go area", "3 of 5 places lie outside the fence: 3, 4, 5");
        assertThat(judge(asks(FILL_IN), "location", at(500, -20)).doubts())
                .containsExactly("The place lies 20.0 m outside the fence");
    }

    @Test
    void valuesThatCannotBeAreRefused() {
        JudgedRequest simulated =
                new JudgedRequest("CreateSimulatedProxy", Map.of(), Map.of("numberToCreate", "make.numberToCreate"));
        JudgedRequest address = new JudgedRequest("ConnectExistingProxy", Map.of(), Map.of("server", "call.server"));

        assertThat(judge(asks(FILL_IN, simulated), "make.numberToCreate", new IntegerValue(99_999))
                        .refusal())
                .contains("1 to 250 simulated boats are added at once, not 99,999");
        assertThat(judge(asks(FILL_IN, simulated), "make.numberToCreate", new IntegerValue(3))
                        .remarks())
                .isEmpty();
        assertThat(judge(asks(FILL_IN, address), "call.server", new TextValue("  "))
                        .refusal())
                .contains("The address of the boat's server is empty: HOST:PORT, such as 192.168.1.101:11411");
        assertThat(judge(asks(FILL_IN, address), "call.server", new TextValue("10.0.0.7"))
                        .refusal())
                .hasValueSatisfying(words -> assertThat(words).contains("'10.0.0.7' is no HOST:PORT"));
    }

    @Test
    void whatAnAreaCostsIsSaidWithTheBoatsThatWouldGo() {
        Judgement judged = judge(
                asks(FILL_IN, exploring(true)), "area", box(300, 500, 600, 800), boat("anna", 100), boat("bert", 100));

        assertThat(judged.doubts()).isEmpty();
        assertThat(judged.costs()).first().isEqualTo("90,002 m² in lanes 50 m apart");
        assertThat(judged.costs().get(1))
                .matches("2 boats: \\d\\.\\d km together; the longest way is (anna|bert)'s, "
                        + "\\d\\.\\d km, about \\d+ min, \\d+ % of a full charge");
    }

    /** A zigzag of 1.5 km turns back 14 times: with a circle of 10 m each turn takes 21 s more at 1.5 m/s. */
    @Test
    void timeCountsTheTurnsOfABoatThatDoesNotTurnOnTheSpot() {
        List<GeoPoint> zigzag = new ArrayList<>();
        for (int i = 0; i < 15; i++) {
            zigzag.add(at(i % 2 == 0 ? 400 : 300, 500 + i));
        }
        Value option = new MapValue(Map.of(new ProxyValue("anna"), new GeoPath(zigzag)));
        DraftAnswer draft = new DraftAnswer(Map.of(), List.of(), Optional.of(option));
        JudgedQuestion question = asks(new Question.ChooseOption(List.of(option)));
        AnswerJudge judge = new AnswerJudge(CrwServices.STANDARD);

        assertThat(judge.judge(question, List.of(boat("anna", 100)), draft).costs())
                .containsExactly("anna: 1.5 km, about 17 min, 43 % of a full charge");
        assertThat(judge.judge(question, List.of(boat("anna", 100, 10)), draft).costs())
                .containsExactly("anna: 1.5 km, about 21 min, 43 % of a full charge");
    }

    @Test
    void whoMayNotComeHomeIsNamed() {
        GeoPath far = new GeoPath(List.of(at(300, 900), at(900, 900)));
        Value option = new MapValue(Map.of(new ProxyValue("anna"), far));
        DraftAnswer draft = new DraftAnswer(Map.of(), List.of(), Optional.of(option));
        JudgedQuestion question = asks(new Question.ChooseOption(List.of(option)));

        Judgement judged = new AnswerJudge(CrwServices.STANDARD)
                .judge(question, List.of(boat("anna", 40), boat("bert", 1)), draft);

        assertThat(judged.costs()).containsExactly("anna: 1.0 km, about 11 min, 29 % of a full charge");
        assertThat(judged.doubts())
                .containsExactly(
                        "anna may not come home: anna has 1.0 km to go and 721 m back, and its charge of 40 % is sure"
                                + " to last for 1.3 km");
        assertThat(new AnswerJudge(CrwServices.STANDARD)
                        .judge(question, List.of(boat("anna", 20)), draft)
                        .doubts())
                .containsExactly(
                        "The way of anna is longer than the charge lasts: anna has 1.0 km to go, and its charge of 20"
                                + " % is sure to last for 636 m");
    }

    @Test
    void whatChosenBoatsComeToNextIsTheirCost() {
        JudgedRequest next = new JudgedRequest(
                "ProxyExploreArea",
                Map.of("area", box(300, 500, 600, 800), "spacing", new RealValue(50), "within", BAY),
                Map.of());
        JudgedQuestion question = new JudgedQuestion(
                new Question.ChooseProxies(List.of("anna", "bert"), 1, 2),
                List.of(),
                List.of(next),
                new WayLimits(List.of(SHOAL), Optional.empty()),
                OperatingArea.OPEN,
                false,
                List.of("anna", "bert"));
        DraftAnswer draft = new DraftAnswer(Map.of(), List.of("bert"), Optional.empty());

        Judgement judged = new AnswerJudge(CrwServices.STANDARD).judge(question, List.of(boat("bert", 30)), draft);

        assertThat(question.boats(draft)).containsExactly("bert");
        assertThat(judged.costs()).anyMatch(words -> words.startsWith("bert: "));
        assertThat(judged.doubts())
                .anyMatch(words -> words.startsWith("charges are sure to last for ") && words.contains("unexplored"));
    }

    @Test
    void anAreaOfWholeSeasIsJudgedAtOnceAndInDoubt() {
        List<GeoPoint> corners = new ArrayList<>(box(0, 0, 300_000, 300_000).outline());
        JudgedQuestion question = new JudgedQuestion(
                FILL_IN,
                List.of(new JudgedRequest(
                        "ProxyExploreArea", Map.of("spacing", new RealValue(1)), Map.of("area", "area"))),
                List.of(),
                new WayLimits(List.of(), Optional.empty()),
                OperatingArea.OPEN,
                false,
                List.of());

        assertThat(judge(question, "area", new GeoArea(corners, List.of()), boat("anna", 100))
                        .doubts())
                .singleElement()
                .asString()
                .contains("km of track in lanes 1 m apart")
                .endsWith(", and all charges together last for 3.2 km");
    }
}
