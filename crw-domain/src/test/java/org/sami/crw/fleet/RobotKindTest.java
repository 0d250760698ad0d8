package org.sami.crw.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.boat.link.LostLinkAction;
import org.sami.crw.proxy.explanation.LostLinkWords;

class RobotKindTest {
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "Connect a boat | Connect a copter",
                "Boats near…, 2 boats. Boat's place | Copters near…, 2 copters. Copter's place",
                "(boat) | (copter)",
                "boat-2 does not answer | boat-2 does not answer",
                "no answer of boat.local:5001 | no answer of boat.local:5001",
                "written to /home/me/boats/x.log | written to /home/me/boats/x.log",
                "C:\\boats\\x.log | C:\\boats\\x.log",
                "Select a boat: it is driven by hand: drive on | Select a copter: it is flown by hand: fly on",
                "a is outside of the water in which boats may go | a is outside of the area in which copters may fly",
                "Close; boats stop their motors and drift | Close; copters stop and hover",
                "Connect one (Ctrl+B), or start the plan that connects boats; each appears | Connect one (Ctrl+B);"
                        + " each appears",
                "boat1 could not do what \"Drive to boats\" asked: the boat left | boat1 could not do what"
                        + " \"Drive to boats\" asked: the copter left",
                "\"boats of my boat.jrnl\" is gone; the boat's \"boat\" | \"boats of my boat.jrnl\" is gone; the"
                        + " copter's \"boat\"",
                "a boat cannot go on in 'boat place': boats' quay | a copter cannot go on in 'boat place': copters'"
                        + " take-off place",
                "a lifeboat | a lifeboat",
                "a boathouse | a boathouse",
                "a boat shows itself: crw boat --mavlink ADDRESS | a copter shows itself: crw boat --mavlink ADDRESS",
                "pair there: crw keys pair HOST:PORT, then boats come | pair there: crw keys pair HOST:PORT, then"
                        + " copters come",
                "mav111 is a boat, and this session flies copters: no boat | mav111 is a boat, and this session flies"
                        + " copters: no copter"
            })
    void theWordIsReplacedAndNamesAndPathsStay(String ofBoats, String ofCopters) {
        assertThat(RobotKind.COPTER.say(ofBoats)).isEqualTo(ofCopters);
    }

    @Test
    void robotOfAnotherKindIsNamedAndInATeamBothKindsAreRight() {
        assertThat(RobotKind.COPTER.unfit(false)).contains("is a boat, and this session flies copters");
        assertThat(RobotKind.BOAT.unfit(true)).contains("is a copter, and this session drives boats");
        assertThat(RobotKind.COPTER.unfit(true)).isEmpty();
        assertThat(RobotKind.BOAT.unfit(false)).isEmpty();
        assertThat(RobotKind.ROBOT.unfit(false)).isEmpty();
        assertThat(RobotKind.ROBOT.unfit(true)).isEmpty();
    }

    @Test
    void lostLinkActionWithoutMotorsIsALandingForWhatFlies() {
        String words = "without a link it " + LostLinkWords.of(LostLinkAction.DRIFT);

        assertThat(RobotKind.BOAT.say(words)).isEqualTo("without a link it stops its motors and drifts");
        assertThat(RobotKind.COPTER.say(words)).isEqualTo("without a link it lands where it is");
        assertThat(RobotKind.ROBOT.say(words))
                .isEqualTo("without a link it stops its motors and drifts, or lands if it flies");
    }

    @ParameterizedTest
    @EnumSource
    void textInWhichTheKindIsThePointNamesItInEachDomain(RobotKind robots) {
        String words = "a was a " + RobotKind.SURFACE_BOAT
                + ", and a copter answers; only surface boats and copters, or" + " surface boat 9";

        assertThat(robots.say(words)).isEqualTo(words);
    }

    @Test
    void textsAboutBoatsAreLeftAlone() {
        assertThat(RobotKind.BOAT.say("Boats near…, 2 boats")).isEqualTo("Boats near…, 2 boats");
    }
}
