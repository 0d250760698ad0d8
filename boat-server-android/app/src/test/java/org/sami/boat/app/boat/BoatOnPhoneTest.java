package org.sami.boat.app.boat;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Random;
import java.util.concurrent.CopyOnWriteArrayList;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.hull.board.BoardState;
import org.sami.boat.hull.position.GpsFix;
import org.sami.boat.hull.position.PositionDoubt;
import org.sami.boat.link.Ack;
import org.sami.boat.link.BatteryLevel;
import org.sami.boat.link.BatteryReport;
import org.sami.boat.link.BoatMode;
import org.sami.boat.link.FileList;
import org.sami.boat.link.HeldWaypoints;
import org.sami.boat.link.KeptFile;
import org.sami.boat.link.ListFiles;
import org.sami.boat.link.Nack;
import org.sami.boat.link.NackReason;
import org.sami.boat.link.PanoramaReport;
import org.sami.boat.link.ReadBack;
import org.sami.boat.link.SensorReport;
import org.sami.boat.link.SettingsReport;
import org.sami.boat.link.SteadyClock;
import org.sami.boat.link.TakePanorama;
import org.sami.boat.link.Teleoperate;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;
import org.sami.boat.server.testing.Await;
import org.sami.boat.server.testing.OwnPort;

/** The boat of a phone, with a board and a base on loopback. */
class BoatOnPhoneTest {
    private static final double LAT = 45.6;
    private static final double LON = 10.6;
    private static final String MOTORS_OFF = "{\"m0\":{\"v\":0.000},\"m1\":{\"v\":0.000}}";

    @TempDir
    Path folder;

    private final SteadyClock clock = SteadyClock.ofThisMachine();
    private final List<String> said = new CopyOnWriteArrayList<>();
    private final TestPictures pictures = new TestPictures();
    private LoopbackBoard board;
    private PhoneHealth health = new PhoneHealth();

    @BeforeEach
    void plugIn() throws IOException {
        board = new LoopbackBoard();
        new PhoneSettings("anna", OwnPort.draw()).write(files());
    }

    @AfterEach
    void unplug() {
        board.close();
    }

    private AppFiles files() {
        return new AppFiles(folder);
    }

    /** A boat with open links: who may reach it is shown in {@link PhoneKeysTest}. */
    private BoatOnPhone begin() throws IOException {
        AppFiles.write(files().openLinks(), "");
        BoatOnPhone boat = new BoatOnPhone(
                files(),
                PhoneSettings.readOrMake(files(), new Random(1)),
                InetAddress.getLoopbackAddress(),
                board.port(),
                pictures,
                health,
                clock,
                said::add);
        boat.start();
        return boat;
    }

    private void fix(BoatOnPhone boat, double lat, double lon) {
        boat.position().gps(new GpsFix(lat, lon, 2, 0, Double.NaN), clock.getAsLong());
        boat.position().compass(0.5, clock.getAsLong());
    }

    private void awaitServing(BoatOnPhone boat, double lat, double lon) {
        Await.until("serves", () -> {
            fix(boat, lat, lon);
            return boat.status().serving() == PhoneStatus.Serving.SERVES;
        });
    }

    @Test
    void servesAsSoonAsItKnowsWhereItIs() throws Exception {
        try (BoatOnPhone boat = begin()) {
            Await.until("board", () -> boat.status().board() == BoardState.CONNECTED);
            assertThat(boat.status().serving()).isEqualTo(PhoneStatus.Serving.WAITS_FOR_POSITION);

            awaitServing(boat, LAT, LON);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                assertThat(base.welcome().boatId()).isEqualTo("anna");
                Await.until("commander", () -> boat.status().commandedBy().equals(Optional.of("base")));
                assertThat(boat.status().mode()).contains(BoatMode.STOPPED);
            }
        }
    }

    @Test
    void begunAgainItHasNameCommandsAndHomeThatItHad() throws Exception {
        String boot;
        Waypoint home;
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                boot = base.welcome().bootId();
                home = base.await(SettingsReport.class).home().orElseThrow();
                base.command(new UploadWaypoints("u", "list", List.of(new Waypoint(LAT, LON + 0.001, 1))), Ack.class);
            }
        }

        try (BoatOnPhone again = begin()) {
            awaitServing(again, LAT + 0.01, LON);
            try (LoopbackBase base = new LoopbackBase(again.status().port(), "anna")) {
                assertThat(base.welcome().bootId()).isNotEqualTo(boot);
                assertThat(base.await(SettingsReport.class).home()).contains(home);
                assertThat(base.command(new ReadBack("r"), HeldWaypoints.class).listId())
                        .isEqualTo("list");
                assertThat(again.status().mode()).contains(BoatMode.STOPPED);
            }
        }
    }

    @Test
    void carriedToOtherWaterItsHomeIsThere() throws Exception {
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
        }
        try (BoatOnPhone again = begin()) {
            awaitServing(again, LAT + 1, LON);
            try (LoopbackBase base = new LoopbackBase(again.status().port(), "anna")) {
                assertThat(base.await(SettingsReport.class).home().orElseThrow().latDeg())
                        .isBetween(LAT + 0.999, LAT + 1.001);
            }
        }
    }

    @Test
    void stoppedOnBoardItDrivesNothingOverARestartUntilItIsReleasedThere() throws Exception {
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                drive(
                        base,
                        () -> !board.newest().equals(MOTORS_OFF)
                                && !board.newest().isEmpty());
                boat.stopNow();
                drive(base, () -> board.newest().equals(MOTORS_OFF));
            }
        }
        try (BoatOnPhone again = begin()) {
            awaitServing(again, LAT, LON);
            assertThat(again.status().isStopped()).isTrue();
            assertThat(again.drive(0.2, 0, 1000)).as("a test of motors").isFalse();
            try (LoopbackBase base = new LoopbackBase(again.status().port(), "anna")) {
                Await.until("board", () -> board.newest().equals(MOTORS_OFF));
                again.release();
                drive(base, () -> !board.newest().equals(MOTORS_OFF));
            }
        }
    }

    private static void drive(LoopbackBase base, java.util.function.BooleanSupplier until) {
        Await.until("motors", () -> {
            try {
                base.say(new Teleoperate(0.5, 0));
            } catch (IOException e) {
                throw new IllegalStateException(e);
            }
            return until.getAsBoolean();
        });
    }

    @Test
    void weakPhoneIsTheWeakBatteryOfTheBoatAndTheBaseIsToldWhich() throws Exception {
        health.setBattery(12, 47);
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            Await.until("voltage", () -> boat.status().boardVolts() > 16);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                assertThat(base.await(BatteryReport.class).level()).isEqualTo(BatteryLevel.CRITICAL);
                SensorReport phone = base.await(SensorReport.class);
                assertThat(phone.sensor()).isEqualTo("phone");
            }
            assertThat(boat.status().troubles())
                    .containsExactly("phone battery 12 %: charge it", "phone is hot, 47 °C: shade it");
        }
    }

    @Test
    void panoramaIsTakenAndItsPicturesAreFilesForTheBase() throws Exception {
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                base.command(new TakePanorama("p", 1), Ack.class);
                PanoramaReport report = base.await(PanoramaReport.class);
                assertThat(report.files()).containsExactly("anna-000001.jpg");

                base.say(new ListFiles("f", KeptFile.PICTURE, ""));
                assertThat(base.await(FileList.class).files())
                        .extracting(KeptFile::name)
                        .containsExactly("anna-000001.jpg");
            }
        }
    }

    @Test
    void panoramaIsRefusedInWordsUntilThePhoneLetsTheAppUseItsCamera() throws Exception {
        pictures.setTrouble("the phone does not let the app use its camera");
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                Nack refused = base.command(new TakePanorama("p", 1), Nack.class);
                assertThat(refused.reason()).isEqualTo(NackReason.NO_CAMERA);
                assertThat(refused.detail()).isEqualTo("the phone does not let the app use its camera");
                assertThat(boat.status().troubles())
                        .containsExactly("no pictures: the phone does not let the app use its camera");

                pictures.setTrouble("");
                base.command(new TakePanorama("q", 1), Ack.class);
            }
        }
    }

    @Test
    void fixesAtNoughtDegreesAreNotTakenForAPlaceAndTheBoatDoesNotServeThere() throws Exception {
        try (BoatOnPhone boat = begin()) {
            for (int i = 0; i < 30; i++) {
                fix(boat, 0, 0);
            }
            assertThat(boat.status().pose().isLocated()).isFalse();
            assertThat(boat.status().doubts()).contains(PositionDoubt.GPS_IMPLAUSIBLE);
            assertThat(boat.status().serving()).isEqualTo(PhoneStatus.Serving.WAITS_FOR_POSITION);

            awaitServing(boat, LAT, LON);
            for (int i = 0; i < 30; i++) {
                fix(boat, 0, 0);
            }
            assertThat(boat.status().pose().latDeg())
                    .as("its place is the one it had")
                    .isBetween(LAT - 0.001, LAT + 0.001);
        }
    }

    @Test
    void boardThatSaysAMegabyteWithoutALineEndStopsTheMotorsAndIsTakenBackAfterIt() throws Exception {
        try (BoatOnPhone boat = begin()) {
            awaitServing(boat, LAT, LON);
            Await.until("board", () -> boat.status().board() == BoardState.CONNECTED);
            try (LoopbackBase base = new LoopbackBase(boat.status().port(), "anna")) {
                drive(
                        base,
                        () -> !board.newest().equals(MOTORS_OFF)
                                && !board.newest().isEmpty());
                board.babble(true);
                drive(base, () -> boat.status().board() == BoardState.SILENT);
                assertThat(boat.status().boardTrouble()).contains("nothing that can be read");
                drive(base, () -> board.newest().equals(MOTORS_OFF));
                Await.until("a megabyte", () -> board.babbled() > 1_000_000);

                board.babble(false);
                drive(
                        base,
                        () -> boat.status().board() == BoardState.CONNECTED
                                && !board.newest().equals(MOTORS_OFF));
            }
        }
    }

    @Test
    void portThatAnotherAppHasIsSaidAndTriedAgain() throws Exception {
        int port = PhoneSettings.readOrMake(files(), new Random(1)).port();
        try (BoatOnPhone boat = begin()) {
            try (ServerSocket other = new ServerSocket(port, 1, InetAddress.getLoopbackAddress())) {
                Await.until("fault", () -> {
                    fix(boat, LAT, LON);
                    return boat.status().serving() == PhoneStatus.Serving.FAILED;
                });
                assertThat(boat.status().troubles().get(0)).startsWith("the boat's server cannot begin: ");
                assertThat(other.isBound()).isTrue();
            }
            awaitServing(boat, LAT, LON);
            assertThat(boat.status().troubles()).isEmpty();
        }
    }

    @Test
    void firstStartMakesANameAndKeepsIt() throws Exception {
        Files.delete(files().settings());

        PhoneSettings made = PhoneSettings.readOrMake(files(), new Random(1));

        assertThat(made.name()).matches("boat-[0-9a-f]{4}");
        assertThat(PhoneSettings.readOrMake(files(), new Random(2)).name()).isEqualTo(made.name());
    }

    @Test
    void damagedNameIsRefusedInsteadOfBecomingAnotherBoat() throws Exception {
        Files.write(files().settings(), "name=an na\nport=80\n".getBytes(StandardCharsets.UTF_8));

        assertThatThrownBy(this::begin)
                .isInstanceOf(IOException.class)
                .hasMessageContaining("boat.txt")
                .hasMessageContaining("'an na'");
    }

    @Test
    void namesAndPortsOutOfTheirLimitsAreRefused() {
        assertThatThrownBy(() -> new PhoneSettings("", 11411)).hasMessageContaining("1 to 40");
        assertThatThrownBy(() -> new PhoneSettings("anna", 80)).hasMessageContaining("1024 to 65535, not 80");
    }
}
