package org.sami.crw.mavlink;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.sami.boat.link.Progress;
import org.sami.boat.link.UploadWaypoints;
import org.sami.boat.link.Waypoint;

class VehicleFilesTest {
    private static final String BOAT = "mav7";

    @TempDir
    private Path folder;

    @Test
    void latchedStopIsKeptWithoutAList() throws Exception {
        VehicleFiles.Kept stopped = new VehicleFiles.Kept("base", Optional.empty(), 0, 0);
        new VehicleFiles(folder).write(BOAT, stopped);

        assertThat(new VehicleFiles(folder).read(BOAT)).isEqualTo(stopped);
    }

    @Test
    void latchedStopIsKeptWhereTheListIsDamaged() throws Exception {
        UploadWaypoints list = new UploadWaypoints("u", "list", List.of(new Waypoint(45.7, 10.7, 1)));
        new VehicleFiles(folder).write(BOAT, new VehicleFiles.Kept("base", Optional.of(list), 500, 0));
        Path file = folder.resolve(BOAT + ".state");
        byte[] half = Files.readAllBytes(file);
        half[half.length / 2] = (byte) 0xff;
        Files.write(file, java.util.Arrays.copyOf(half, half.length / 2 + 1));

        assertThat(new VehicleFiles(folder).read(BOAT))
                .isEqualTo(new VehicleFiles.Kept("base", Optional.empty(), 0, 0));
    }

    @Test
    void howFarItHasComeCountsForItsListOnly() throws Exception {
        Waypoint place = new Waypoint(45.7, 10.7, 1);
        UploadWaypoints list = new UploadWaypoints("u", "list", List.of(place, place, place));
        VehicleFiles files = new VehicleFiles(folder);
        files.write(BOAT, new VehicleFiles.Kept("", Optional.of(list), 4, 0));

        files.write(BOAT, new Progress("list", 2, false));
        assertThat(files.read(BOAT).next()).isEqualTo(2);
        files.write(BOAT, new Progress("another", 1, false));
        assertThat(files.read(BOAT).next()).isZero();
        files.write(BOAT, new Progress("list", 99, true));
        assertThat(files.read(BOAT).next()).isEqualTo(3);
        Files.writeString(folder.resolve(BOAT + ".progress"), "list\n2");
        assertThat(files.read(BOAT).next()).isEqualTo(2);
        Files.write(folder.resolve(BOAT + ".progress"), new byte[] {(byte) 0xff, '\n', '2'});
        assertThat(files.read(BOAT).next()).isZero();
    }
}
