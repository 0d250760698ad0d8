package org.sami.crw.log;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class LineParserTest {
    private final LineParser parser = new LineParser();

    @Test
    void poseOfBothDialectsIsAPlaceAndAHeading() throws Exception {
        LoggedLine line =
                parser.parse(7, "2501 9:03:07,5 POSE: {500000.0, 4482781.5, 172.35, Q[0.0,0.0,-1.25]} @ 17North ");

        assertThat(line.number()).isEqualTo(7);
        assertThat(line.atMillis()).isEqualTo(2501);
        assertThat(line.clock()).isEqualTo("9:03:07,5");
        LogEntry.Pose pose = (LogEntry.Pose) line.entry();
        assertThat(pose.at().lonDeg()).isCloseTo(-81, within(1e-7));
        assertThat(pose.at().latDeg()).isCloseTo(40.495, within(0.01));
        assertThat(pose.yawRad()).isEqualTo(-1.25);
    }

    @Test
    void satelliteFixNamesItsZoneByTheBandsLetter() throws Exception {
        LogEntry entry = parser.parse(1, "1 01:02:03,4 GPS: [500000.0 m, 4482781.5 m], 17T, 190.0, 210.5 ")
                .entry();

        assertThat(((LogEntry.Fix) entry).at().lonDeg()).isCloseTo(-81, within(1e-7));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "VEL: Twist[0.5, 0.0, 0.0, 0.0, 0.0, -0.25]  | VEL                             | 1 | 0.5",
                "COMPASS: -1.15                              | COMPASS                         | 1 | -1.15",
                "COMPASS_DIFF_DEG: 2.5E-2                    | COMPASS_DIFF_DEG                | 1 | 0.025",
                "RUDDER: [r, 0.25]                           | RUDDER                          | 1 | 0.25",
                "ES2: [e, 9.0, 30.0]                         | ES2                             | 2 | 30.0",
                "GYRO_VALUES: [-7.3E-4, -0.5, 0.25]          | GYRO_VALUES                     | 3 | 0.25",
                "MAGNETIC_ACCURACY: 3                        | MAGNETIC_ACCURACY               | 1 | 3",
                "SENSOR4: {\"data\":\"12.5 0.0 15.0\",\"type\":\"battery\"} | SENSOR4 battery    | 3 | 15",
                "SENSOR2: {\"type\":\"es2\",\"t\":19.5,\"c\":780}           | SENSOR2 es2        | c | 780",
                "Battery Voltage: 4 Sensor4(BATTERY)[12.5, 9.0, 0.0] | Battery Voltage Sensor4(BATTERY) | 2 | 9",
            })
    void readingsAreTakenByTheirChannel(String text, String sensor, String channel, double value) throws Exception {
        LogEntry.Reading reading =
                (LogEntry.Reading) parser.parse(1, "1 01:02:03,4 " + text).entry();

        assertThat(reading.sensor()).isEqualTo(sensor);
        assertThat(reading.values()).containsEntry(channel, value);
    }

    @ParameterizedTest
    @ValueSource(strings = {"25 9:03:07,5 ", "25\tI\t"})
    void lineOfTwentySixteenIsJsonAfterATimeOrALevel(String head) throws Exception {
        LoggedLine pose = parser.parse(
                1, head + "{\"pose\":{\"p\":[500000.0,4482781.5,172],\"q\":[0.8,0,-0.6,0],\"zone\":\"17North\"}} ");
        LoggedLine sensor = parser.parse(2, head + "{\"sensor\":{\"channel\":3,\"type\":\"ES2\",\"data\":[249,19.5]}}");
        LoggedLine command = parser.parse(3, head + "{\"cmd\":{\"m0\":{\"v\":0}}}");

        assertThat(pose.atMillis()).isEqualTo(25);
        assertThat(((LogEntry.Pose) pose.entry()).at().lonDeg()).isCloseTo(-81, within(1e-7));
        assertThat(((LogEntry.Pose) pose.entry()).yawRad()).isCloseTo(-1.287, within(1e-3));
        assertThat(sensor.entry()).isEqualTo(new LogEntry.Reading("sensor3 ES2", Map.of("1", 249.0, "2", 19.5)));
        assertThat(command.entry()).isEqualTo(new LogEntry.Command("{\"m0\":{\"v\":0}}"));
    }

    @Test
    void dateOfALogIsItsClockAndATopicThatNobodyKnowsIsNamed() throws Exception {
        LoggedLine date = parser.parse(1, "0\tI\t{\"date\":\"Thu May 19 13:36:23 EDT 2016\",\"time\":1463679383361}");

        assertThat(date.clock()).isEqualTo("Thu May 19 13:36:23 EDT 2016");
        assertThat(date.entry()).isEqualTo(new LogEntry.Reading("date", Map.of("time", 1463679383361.0)));
        assertThatThrownBy(() -> parser.parse(2, "1\tI\t{\"tide\":{\"low\":true}}"))
                .isInstanceOfSatisfying(
                        BadLineException.class, bad -> assertThat(bad.fault()).isEqualTo(LineFault.UNKNOWN_TOPIC))
                .hasMessageContaining("'tide'");
    }

    @Test
    void valueThatIsNoNumberIsKeptAsThat() throws Exception {
        LogEntry.Reading reading =
                (LogEntry.Reading) parser.parse(1, "1 01:02:03,4 COMPASS: NaN").entry();

        assertThat(reading.values()).isEqualTo(Map.of("1", Double.NaN));
    }

    @ParameterizedTest
    @ValueSource(strings = {"CMD: {\"m1\":{\"v\":0}}", "PIDGAINS: 5 2.0,0.0,3.0", "SETGAINS: 0 [3.0, 0.0, 0.0]"})
    void commandsAreKeptAsWritten(String text) throws Exception {
        LogEntry.Command command =
                (LogEntry.Command) parser.parse(1, "1 01:02:03,4 " + text).entry();

        assertThat(text).endsWith(command.text());
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "hello                                                  | NO_ENTRY",
                "12 POSE: {}                                            | NO_ENTRY",
                "-5 01:02:03,4 COMPASS: 1                               | NO_ENTRY",
                "5 01:02:03,4 SONAR: 1                                  | UNKNOWN_TOPIC",
                "5 01:02:03,4 POSE: {500000.0, 4482781.5, 1.0, Q[0.0,0  | BAD_CONTENT",
                "5 01:02:03,4 POSE: {NaN, NaN, 1.0, Q[0.0,0.0,0.0]} @ 17North | BAD_CONTENT",
                "5 01:02:03,4 POSE: {500000.0, 4.0, 1.0, Q[0.0,0.0,0.0]} @ 77North | BAD_CONTENT",
                "5 01:02:03,4 COMPASS: north                            | BAD_CONTENT",
                "5 01:02:03,4 COMPASS:                                  | BAD_CONTENT",
                "5 01:02:03,4 SENSOR1: {\"data\":\"7.78\"}              | BAD_CONTENT",
                "5 01:02:03,4 SENSOR1: {\"data\":\"a b\",\"type\":\"x\"} | BAD_CONTENT",
                "5 01:02:03,4 CMD: {\"m1\":                             | BAD_CONTENT",
                "5 01:02:03,4 CMD: {} {}                                | BAD_CONTENT",
            })
    void whatIsNotUnderstoodSaysWhatIsWrong(String text, LineFault fault) {
        assertThatThrownBy(() -> parser.parse(1, text)).isInstanceOfSatisfying(BadLineException.class, e -> {
            assertThat(e.fault()).isEqualTo(fault);
            assertThat(e.getMessage()).isNotBlank();
        });
    }
}
