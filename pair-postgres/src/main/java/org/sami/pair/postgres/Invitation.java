package org.sami.pair.postgres;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Properties;

/**
 * The file by which the second base joins a pair. It holds the pair's secrets.
 *
 * @param settings as the second base sees the pair
 */
public record Invitation(PairSettings settings, PairSecrets secrets) {
    /** Writes it, readable by its owner alone; a file that is there is replaced. */
    public void write(Path file) throws IOException {
        Properties values = new Properties();
        values.setProperty("here", settings.here());
        values.setProperty("other", settings.other());
        values.setProperty("port", Integer.toString(settings.port()));
        values.setProperty("when-cut", settings.whenCut().text());
        values.setProperty("admin", secrets.admin());
        values.setProperty("session", secrets.session());
        values.setProperty("replica", secrets.replica());
        values.setProperty("key", secrets.key());
        values.setProperty("certificate", secrets.certificate());
        PrivateFile.write(file, PairFolder.text(values));
    }

    /**
     * Reads one.
     *
     * @throws PairException if it cannot be read, or is none
     */
    public static Invitation read(Path file) throws PairException {
        Properties values = PairFolder.read(file);
        try {
            return new Invitation(
                    new PairSettings(
                            PairFolder.required(values, "here", file),
                            PairFolder.required(values, "other", file),
                            Integer.parseInt(PairFolder.required(values, "port", file)),
                            WhenCut.parse(PairFolder.required(values, "when-cut", file))),
                    new PairSecrets(
                            PairFolder.required(values, "admin", file),
                            PairFolder.required(values, "session", file),
                            PairFolder.required(values, "replica", file),
                            PairFolder.required(values, "key", file),
                            PairFolder.required(values, "certificate", file)));
        } catch (IllegalArgumentException unfit) {
            throw new PairException(file + " is no invitation to a pair: " + unfit.getMessage(), unfit);
        }
    }
}
