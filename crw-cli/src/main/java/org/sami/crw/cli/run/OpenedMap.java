package org.sami.crw.cli.run;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Optional;
import org.sami.crw.cli.output.UsageFault;
import org.sami.session.map.TileFile;

/** The background map that an option named, or none. */
record OpenedMap(Optional<TileFile> tiles) implements AutoCloseable {
    /**
     * Opens it.
     *
     * @throws UsageFault if it is none
     */
    static OpenedMap of(Optional<Path> file) {
        try {
            return new OpenedMap(file.isPresent() ? Optional.of(TileFile.open(file.get())) : Optional.empty());
        } catch (IOException unfit) {
            throw new UsageFault("--map: " + unfit.getMessage());
        }
    }

    @Override
    public void close() throws IOException {
        if (tiles.isPresent()) {
            tiles.get().close();
        }
    }
}
