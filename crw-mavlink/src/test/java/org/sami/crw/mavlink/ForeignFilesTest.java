package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import org.sami.crw.fleet.RobotKind;

class ForeignFilesTest {
    private static final String BOAT = "mav1";
    private static final VehicleFiles.Kept STOPPED = new VehicleFiles.Kept("base", Optional.empty(), 0, 0);

    @TempDir
    private Path folder;

    private VehicleFiles files;

    @BeforeEach
    void place() {
        files = new VehicleFiles(folder);
    }

    private ForeignFiles given(String number, boolean flies) {
        return new ForeignFiles(BOAT, files, number, flies);
    }

    @Test
    void filesOfEarlierVersionsAreThoseOfTheFirstVehicleThatComes() throws Exception {
        files.write(BOAT, STOPPED);

        assertThat(given("0a", false).news()).isEmpty();
        assertThat(files.read(BOAT)).isEqualTo(STOPPED);
    }

    @Test
    void whatIsKeptOfEachVehicleComesBackWithIt() throws Exception {
        assertThat(given("0a", false).ofStarts()).isEmpty();
        files.write(BOAT, STOPPED);
        files.write(BOAT, new VehicleConsumption(350, 10));

        assertThat(given("0b", false).ofStarts()).isEqualTo(" of vehicle 2");
        assertThat(files.read(BOAT)).isEqualTo(VehicleFiles.Kept.NOTHING);
        assertThat(files.consumption(BOAT).metres()).isZero();
        files.write(BOAT, new VehicleConsumption(100, 10));

        ForeignFiles back = given("0a", false);
        assertThat(back.news()).isPresent();
        assertThat(back.news()).isEmpty();
        assertThat(files.read(BOAT)).isEqualTo(STOPPED);
        assertThat(files.consumption(BOAT).metres()).isEqualTo(350);
    }

    @Test
    void copterGetsNothingOfABoatAlsoWithoutNumbers() throws Exception {
        given("", false);
        files.write(BOAT, STOPPED);

        assertThat(given("", true).news().orElseThrow())
                .startsWith("mav1 is a copter, and the last one with its number was a surface boat: ")
                .contains("also that it was stopped by base: this one is not stopped");
        assertThat(files.read(BOAT)).isEqualTo(VehicleFiles.Kept.NOTHING);
        given("", false);
        assertThat(files.read(BOAT)).isEqualTo(STOPPED);
    }

    @ParameterizedTest
    @EnumSource
    void kindsOfBothAreNamedInSessionsOfEachKind(RobotKind robots) throws Exception {
        given("", false);
        String copter = robots.say(given("", true).news().orElseThrow());
        String boat = robots.say(given("", false).news().orElseThrow());
        given("0a", false);
        String anotherBoat = robots.say(given("0b", false).news().orElseThrow());

        assertThat(copter).startsWith("mav1 is a copter, and the last one with its number was a surface boat: ");
        assertThat(boat).startsWith("mav1 is a surface boat, and the last one with its number was a copter: ");
        assertThat(anotherBoat).startsWith("mav1 is another surface boat than the last one with its number: ");
    }

    @Test
    void numberThatIsSaidLateTellsWhetherTheFilesAreItsOwn() throws Exception {
        given("0a", false);
        files.write(BOAT, STOPPED);

        ForeignFiles unsaid = given("", false);
        assertThat(files.read(BOAT)).isEqualTo(STOPPED);
        assertThat(unsaid.isOfAnother("")).isFalse();
        assertThat(unsaid.isOfAnother("0a")).isFalse();
        assertThat(unsaid.isOfAnother("0b")).isTrue();
    }

    @Test
    void damagedNoteOfTheVehicleLosesNoFleetStop() throws Exception {
        given("0a", false);
        files.write(BOAT, STOPPED);
        Files.writeString(folder.resolve(BOAT + ".vehicle"), "0a\nboa");

        given("0b", false);
        assertThat(files.read(BOAT)).isEqualTo(STOPPED);
    }
}
