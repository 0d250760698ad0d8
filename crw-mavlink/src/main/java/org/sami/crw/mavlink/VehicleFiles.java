package org.sami.crw.mavlink;

import java.io.IOException;
import java.lang.System.Logger.Level;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.List;
import java.util.Objects;
import java.util.Optional;
import org.sami.boat.link.LinkCodec;
import org.sami.boat.link.LinkException;
import org.sami.boat.link.UploadWaypoints;

/**
 * What this machine stores for each vehicle because the autopilot cannot: the id and the waypoints of the list that it was given last, and who latched its
 * fleet stop. After a crash the next base finds the list again. One small file for each vehicle, replaced as a whole. For one thread at a time.
 */
public final class VehicleFiles {
    private static final System.Logger LOG = System.getLogger(VehicleFiles.class.getName());

    private final Path folder;

    /**
     * What is kept of one vehicle.
     *
     * @param stoppedBy who has latched its fleet stop; empty where it is not latched
     * @param list the list that it was given last, as the base sent it
     */
    record Kept(String stoppedBy, Optional<UploadWaypoints> list) {
        static final Kept NOTHING = new Kept("", Optional.empty());
    }

    /** Files in a folder, which is made when something is kept. */
    public VehicleFiles(Path folder) {
        this.folder = Objects.requireNonNull(folder, "folder");
    }

    /** In the folder of this machine's user, or in that which the system property {@code sami.vehicles} names. */
    public static VehicleFiles ofThisUser() {
        return new VehicleFiles(Optional.ofNullable(System.getProperty("sami.vehicles"))
                .map(Path::of)
                .orElseGet(() -> Path.of(System.getProperty("user.home"), ".config", "sami", "vehicles")));
    }

    /** What is kept of a vehicle; no list where its line is damaged, as the base then sends it again. A latched stop is read whatever the list is. */
    Kept read(String name) {
        Path file = file(name);
        if (!Files.exists(file)) {
            return Kept.NOTHING;
        }
        try {
            List<String> lines = new String(
                            Files.readAllBytes(file), StandardCharsets.UTF_8) // damaged bytes are no fault
                    .lines()
                    .toList();
            return new Kept(
                    lines.stream().findFirst().orElse(""),
                    lines.stream().skip(1).findFirst().flatMap(line -> list(file, line)));
        } catch (IOException e) {
            LOG.log(Level.WARNING, file + " cannot be read; the vehicle is sent its list again", e);
            return Kept.NOTHING;
        }
    }

    private static Optional<UploadWaypoints> list(Path file, String line) {
        if (line.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(LinkCodec.readBody(line.getBytes(StandardCharsets.UTF_8)))
                    .filter(UploadWaypoints.class::isInstance)
                    .map(UploadWaypoints.class::cast);
        } catch (LinkException e) {
            LOG.log(Level.WARNING, file + " has a damaged list; the vehicle is sent its list again", e);
            return Optional.empty();
        }
    }

    /**
     * Keeps it in place of what was kept.
     *
     * @throws IOException if it cannot be written; what was kept before stays
     */
    void write(String name, Kept kept) throws IOException {
        Files.createDirectories(folder);
        Path next = folder.resolve(name + ".next");
        String list = kept.list()
                .map(upload -> new String(LinkCodec.body(upload), StandardCharsets.UTF_8))
                .orElse("");
        Files.writeString(next, kept.stoppedBy() + "\n" + list + "\n");
        Files.move(next, file(name), StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private Path file(String name) {
        return folder.resolve(name + ".state");
    }
}
