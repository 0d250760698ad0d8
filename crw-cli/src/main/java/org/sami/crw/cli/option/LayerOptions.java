package org.sami.crw.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.layer.CurrentField;
import org.sami.crw.sim.layer.DepthGrid;
import org.sami.crw.sim.layer.WaterLayers;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.FileTooLargeException;
import picocli.CommandLine.Option;

/** The options that say what differs by place on the water of simulated boats. */
public final class LayerOptions {
    @Option(
            names = "--depths",
            paramLabel = "FILE",
            description =
                    "Depths of the water of simulated boats, which their sonar measures (ESRI ASCII grid in degrees,"
                            + " metres below the surface; see docs/command-line.md). Without it they have no sonar"
                            + " (default: none).")
    private @Nullable Path depths;

    @Option(
            names = "--currents",
            paramLabel = "FILE",
            description =
                    "Currents by place on the water of simulated boats, which carry them (CSV: lat,lon,speed,direction"
                            + " in m/s and degrees; see docs/command-line.md), besides --current (default: none).")
    private @Nullable Path currents;

    /**
     * The layers of the files.
     *
     * @param folder that the files are looked for in
     * @throws UsageFault if a file cannot be read or makes no sense
     */
    public WaterLayers layers(Path folder) {
        return new WaterLayers(
                read("--depths", depths, folder, DepthGrid::parse),
                read("--currents", currents, folder, CurrentField::parse));
    }

    private static <T> Optional<T> read(String option, @Nullable Path file, Path folder, Function<String, T> parser) {
        if (file == null) {
            return Optional.empty();
        }
        try {
            return Optional.of(parser.apply(BoundedFile.text(folder.resolve(file), BoundedFile.DATA_BYTES)));
        } catch (FileTooLargeException | IllegalArgumentException e) {
            throw new UsageFault(option + ": " + file.getFileName() + ": " + e.getMessage());
        } catch (IOException e) {
            throw new UsageFault(option + ": cannot read " + folder.resolve(file));
        }
    }
}
