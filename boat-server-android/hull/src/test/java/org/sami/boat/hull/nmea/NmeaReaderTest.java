package org.sami.boat.hull.nmea;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.sami.boat.hull.position.GpsFix;

class NmeaReaderTest {
    private final List<GpsFix> fixes = new ArrayList<>();
    private final List<String> headings = new ArrayList<>();
    private final NmeaReader reader = new NmeaReader(new NmeaReader.Sink() {
        @Override
        public void fix(GpsFix fix) {
            fixes.add(fix);
        }

        @Override
        public void magneticHeading(double rad) {
            headings.add("magnetic " + Math.round(Math.toDegrees(rad)));
        }

        @Override
        public void trueHeading(double rad) {
            headings.add("true " + Math.round(Math.toDegrees(rad)));
        }

        @Override
        public void declination(double rad) {
            headings.add("declination " + Math.round(Math.toDegrees(rad)));
        }
    });

    private void read(String body) {
        reader.line(NmeaSentence.line(body).trim());
    }

    @Test
    void exampleOfTheStandardIsRead() {
        reader.line("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6A");

        GpsFix fix = fixes.get(0);
        assertThat(fix.latDeg()).isCloseTo(48.1173, within(1e-6));
        assertThat(fix.lonDeg()).isCloseTo(11.516667, within(1e-6));
        assertThat(fix.speedMps()).isCloseTo(11.52, within(0.01));
        assertThat(Math.toDegrees(fix.courseRad())).isCloseTo(84.4, within(1e-9));
        assertThat(headings).containsExactly("declination -3");
    }

    @Test
    void southAndWestAreNegative() {
        read("GNRMC,1,A,3345.6000,S,07030.0000,W,0.0,,,,");

        assertThat(fixes.get(0).latDeg()).isCloseTo(-33.76, within(1e-9));
        assertThat(fixes.get(0).lonDeg()).isCloseTo(-70.5, within(1e-9));
        assertThat(fixes.get(0).courseRad()).isNaN();
    }

    @Test
    void receiverWithBothSentencesIsTakenAtItsRmcWithTheAccuracyOfItsGga() {
        read("GPRMC,1,A,4807.038,N,01131.000,E,1.0,0.0,,,");
        read("GPGGA,1,4807.038,N,01131.000,E,1,08,2.0,545.4,M,46.9,M,,");
        read("GPRMC,2,A,4807.038,N,01131.000,E,1.0,0.0,,,");

        assertThat(fixes).hasSize(2);
        assertThat(fixes.get(1).accuracyM()).isEqualTo(5);
    }

    @Test
    void receiverWithGgaAloneIsTakenAtThat() {
        read("GPGGA,1,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,");

        assertThat(fixes).hasSize(1);
        assertThat(fixes.get(0).speedMps()).isNaN();
    }

    @Test
    void noFixIsNoPosition() {
        read("GPRMC,1,V,,,,,,,,,");
        read("GPGGA,1,,,,,0,00,,,M,,M,,");

        assertThat(fixes).isEmpty();
    }

    @Test
    void headingsAreToldApart() {
        read("HCHDG,101.1,,,7.1,W");
        read("HCHDM,90.0,M");
        read("GPHDT,270.0,T");
        read("GPHDT,,T");

        assertThat(headings).containsExactly("declination -7", "magnetic 101", "magnetic 90", "true 270");
    }

    @Test
    void damagedSentencesAreCountedAndLeftOut() {
        reader.line("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4,084.4,230394,003.1,W*6B");
        reader.line("$GPRMC,123519,A,4807.038,N,01131.000,E,022.4");
        reader.line("x".repeat(1000));
        reader.line("$*00");
        read("GPRMC,1,A,9907.038,N,01131.000,E,1.0,0.0,,,");

        assertThat(reader.unread()).isEqualTo(4);
        assertThat(fixes).allSatisfy(fix -> assertThat(fix.latDeg()).isNaN()); // no latitude has 99 degrees
    }

    @Test
    void wholeSentenceBehindAHalfOneIsRead() {
        reader.line("$GPRMC,1235" + NmeaSentence.line("GPHDT,10.0,T").trim());

        assertThat(headings).containsExactly("true 10");
    }
}
