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
import org.sami.boat.link.Progress;
import org.sami.boat.link.UploadWaypoints;

/**
 * What this machine stores for each vehicle because the autopilot cannot: the id and the waypoints of the list that it was given last, how far it holds them
 * and has come along them, and who latched its fleet stop; how far it drove on how much charge; and which fence it was given. The next base finds the list
 * again and goes on along it. Four files for each vehicle, each replaced as a whole, and one that says whose they are. For one thread at a time.
 */
public final class VehicleFiles {
    private static final System.Logger LOG = System.getLogger(VehicleFiles.class.getName());

    private static final List<String> KINDS = List.of(".state", ".progress", ".consumption", ".fence");

    private final Path folder;

    /**
     * What is kept of one vehicle.
     *
     * @param stoppedBy who has latched its fleet stop; empty where it is not latched
     * @param list the list that it was given last, as the base sent it
     * @param heldTo the end of the part of the list that it held ({@link MissionWindow#to}); 0 where that is not known
     * @param next the waypoint of the list to which it was under way; 0 where that is not known
     */
    record Kept(String stoppedBy, Optional<UploadWaypoints> list, int heldTo, int next) {
        static final Kept NOTHING = new Kept("", Optional.empty(), 0, 0);
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

    /**
     * Whose files these are, by what was heard last with the id; empty where that is not known, as in files of earlier versions.
     */
    Optional<VehicleOwner> owner(String name) {
        Path file = ownerFile(name);
        try {
            return Files.exists(file) ? Optional.of(VehicleOwner.of(Files.readAllLines(file))) : Optional.empty();
        } catch (IOException | IllegalArgumentException e) {
            LOG.log(Level.WARNING, file + " cannot be read; what is kept is taken for that of this vehicle", e);
            return Optional.empty();
        }
    }

    /**
     * Gives the files to the vehicle that has the id now. What is kept of another one is set aside until that one comes again.
     *
     * @return whose they are from now on
     * @throws IOException if that cannot be written; what is kept may be partly another one's then
     */
    VehicleOwner give(String name, String number, boolean flies) throws IOException {
        VehicleOwner asked = new VehicleOwner(number, flies, 0);
        VehicleOwner before = owner(name).orElse(asked);
        boolean isAnother = before.isAnother(asked);
        VehicleOwner now = isAnother
                ? new VehicleOwner(number, flies, before.vehicles() + 1)
                : new VehicleOwner(number.isEmpty() ? before.number() : number, flies, before.vehicles());
        if (isAnother) {
            for (String kind : KINDS) {
                move(name + kind, name + "." + before.key() + kind);
                move(name + "." + now.key() + kind, name + kind);
            }
        }
        if (!owner(name).equals(Optional.of(now))) {
            replace(name, ownerFile(name), String.join("\n", now.lines()) + "\n");
        }
        return now;
    }

    private void move(String from, String to) throws IOException {
        if (Files.exists(folder.resolve(from))) {
            Files.move(folder.resolve(from), folder.resolve(to), StandardCopyOption.REPLACE_EXISTING);
        }
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
            Optional<UploadWaypoints> list = lines.stream().skip(1).findFirst().flatMap(line -> list(file, line));
            return new Kept(
                    lines.stream().findFirst().orElse(""),
                    list,
                    lines.stream().skip(2).findFirst().map(VehicleFiles::number).orElse(0),
                    list.map(upload -> next(name, upload)).orElse(0));
        } catch (IOException e) {
            LOG.log(Level.WARNING, file + " cannot be read; the vehicle is sent its list again", e);
            return Kept.NOTHING;
        }
    }

    /** The waypoint of a list to which a vehicle was under way; its first where that is not known. */
    private int next(String name, UploadWaypoints list) {
        Path file = progressFile(name);
        try {
            List<String> lines = Files.exists(file) ? Files.readAllLines(file) : List.of();
            boolean isOfList = lines.size() == 2 && lines.get(0).equals(list.listId());
            return isOfList ? Math.min(number(lines.get(1)), list.waypoints().size()) : 0;
        } catch (IOException e) {
            LOG.log(Level.WARNING, file + " cannot be read; the vehicle's list begins with its first waypoint", e);
            return 0;
        }
    }

    private static int number(String line) {
        return line.matches("[0-9]{1,6}") ? Integer.parseInt(line) : 0;
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
     * Keeps it in place of what was kept, except {@link Kept#next}, which {@link #write(String, Progress)} keeps.
     *
     * @throws IOException if it cannot be written; what was kept before stays
     */
    void write(String name, Kept kept) throws IOException {
        String list = kept.list()
                .map(upload -> new String(LinkCodec.body(upload), StandardCharsets.UTF_8))
                .orElse("");
        replace(name, file(name), kept.stoppedBy() + "\n" + list + "\n" + kept.heldTo() + "\n");
    }

    /**
     * Keeps how far a vehicle has come along its list in place of what was kept. A file of its own, as a list may be long.
     *
     * @throws IOException if it cannot be written; what was kept before stays
     */
    void write(String name, Progress progress) throws IOException {
        replace(name, progressFile(name), progress.listId() + "\n" + progress.nextIndex() + "\n");
    }

    /** What was counted of a vehicle's consumption; nothing where nothing was, or its file is damaged. */
    VehicleConsumption consumption(String name) {
        Path file = consumptionFile(name);
        try {
            List<String> lines = Files.exists(file) ? Files.readAllLines(file) : List.of("0", "0");
            double metres = Double.parseDouble(lines.get(0));
            double percent = Double.parseDouble(lines.get(1));
            boolean whole = metres >= 0 && percent >= 0 && Double.isFinite(metres + percent);
            return whole ? new VehicleConsumption(metres, percent) : new VehicleConsumption(0, 0);
        } catch (IOException | IndexOutOfBoundsException | NumberFormatException e) {
            LOG.log(
                    Level.WARNING,
                    file + " cannot be read; the vehicle's consumption is counted from the beginning",
                    e);
            return new VehicleConsumption(0, 0);
        }
    }

    /**
     * Keeps what was counted of a vehicle's consumption in place of what was kept.
     *
     * @throws IOException if it cannot be written; what was kept before stays
     */
    void write(String name, VehicleConsumption counted) throws IOException {
        replace(name, consumptionFile(name), counted.metres() + "\n" + counted.percent() + "\n");
    }

    /** The fences that bases of this machine gave to a vehicle and did not take away, as {@link FenceItems#text}; none where its file is damaged. */
    List<String> fences(String name) {
        Path file = fenceFile(name);
        try {
            return Files.exists(file) ? Files.readAllLines(file) : List.of();
        } catch (IOException e) {
            LOG.log(
                    Level.WARNING,
                    file + " cannot be read; a fence that the vehicle holds is taken for its owner's",
                    e);
            return List.of();
        }
    }

    /**
     * Keeps the fences that a vehicle was given in place of what was kept.
     *
     * @throws IOException if it cannot be written; what was kept before stays
     */
    void writeFences(String name, List<String> fences) throws IOException {
        replace(name, fenceFile(name), String.join("\n", fences));
    }

    private void replace(String name, Path file, String text) throws IOException {
        Files.createDirectories(folder);
        Path next = folder.resolve(name + ".next");
        Files.writeString(next, text);
        Files.move(next, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private Path ownerFile(String name) {
        return folder.resolve(name + ".vehicle");
    }

    private Path progressFile(String name) {
        return folder.resolve(name + ".progress");
    }

    private Path consumptionFile(String name) {
        return folder.resolve(name + ".consumption");
    }

    private Path fenceFile(String name) {
        return folder.resolve(name + ".fence");
    }

    private Path file(String name) {
        return folder.resolve(name + ".state");
    }
}
