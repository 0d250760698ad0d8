package org.sami.crw.fleet;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

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
                "a lifeboat | a lifeboat",
                "a boathouse | a boathouse"
            })
    void theWordIsReplacedAndNamesAndPathsStay(String ofBoats, String ofCopters) {
        assertThat(RobotKind.COPTER.say(ofBoats)).isEqualTo(ofCopters);
    }

    @Test
    void textsAboutBoatsAreLeftAlone() {
        assertThat(RobotKind.BOAT.say("Boats near…, 2 boats")).isEqualTo("Boats near…, 2 boats");
    }
}
