package org.sami.crw.cli.option;

import java.io.IOException;
import java.nio.file.Path;
import org.sami.crw.cli.output.UsageFault;
import org.sami.crw.sim.vessel.ForeignVessels;
import org.sami.spn.json.BoundedFile;
import org.sami.spn.json.FileTooLargeException;

/** Reads a file of foreign vessels that an option names. */
public final class VesselsFile {
    private VesselsFile() {}

    /**
     * The vessels of a file.
     *
     * @param option for messages
     * @throws UsageFault if it cannot be read or makes no sense
     */
    public static ForeignVessels read(Path file, String option) {
        try {
            return ForeignVessels.parse(BoundedFile.text(file, BoundedFile.DATA_BYTES));
        } catch (FileTooLargeException | IllegalArgumentException e) {
            throw new UsageFault(option + ": " + file.getFileName() + ": " + e.getMessage());
        } catch (IOException e) {
            throw new UsageFault(option + ": cannot read " + file);
        }
    }
}
