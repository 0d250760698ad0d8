package org.sami.mavlink.param;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.time.Instant;
import java.util.Locale;
import java.util.Objects;
import java.util.Optional;
import java.util.SortedMap;
import java.util.TreeMap;
import org.sami.mavlink.vehicle.VehicleId;

/**
 * Parameters in files, one for each vehicle: {@code vehicle-3.parm} with a line {@code NAME VALUE} for each, as ground stations and ArduPilot's simulator read
 * them. A file that cannot be read completely is ignored. For one thread at a time.
 */
public record ParameterFiles(Path folder) {
    /** Files in a folder, which is made when the first is written. */
    public ParameterFiles {
        Objects.requireNonNull(folder, "folder");
    }

    private Path file(VehicleId vehicle) {
        return folder.resolve("vehicle-" + vehicle + ".parm");
    }

    /** What is kept of a vehicle. */
    public Optional<KeptParameters> load(VehicleId vehicle) {
        try {
            SortedMap<String, Double> values = new TreeMap<>();
            for (String line : Files.readAllLines(file(vehicle))) {
                String[] words = line.strip().split("[\\s,]+", -1);
                if (words.length != 2) {
                    return Optional.empty();
                }
                values.put(words[0], Double.valueOf(words[1]));
            }
            Instant since = Files.getLastModifiedTime(file(vehicle)).toInstant();
            return values.isEmpty() ? Optional.empty() : Optional.of(new KeptParameters(since, values));
        } catch (IOException | NumberFormatException e) {
            return Optional.empty();
        }
    }

    /**
     * Keeps the parameters of a vehicle, in place of those that were kept before.
     *
     * @throws UncheckedIOException if the file cannot be written; it is as before then
     */
    public void keep(VehicleId vehicle, SortedMap<String, Double> values) {
        StringBuilder text = new StringBuilder();
        values.forEach((name, value) ->
                text.append(String.format(Locale.ROOT, "%s %s%n", name, KeptParameters.written(value))));
        try {
            Files.createDirectories(folder);
            Path whole = folder.resolve("vehicle-" + vehicle + ".parm.new");
            Files.writeString(whole, text);
            Files.move(whole, file(vehicle), StandardCopyOption.REPLACE_EXISTING);
        } catch (IOException e) {
            throw new UncheckedIOException(file(vehicle) + " cannot be written", e);
        }
    }
}
