package org.sami.crw.gui;

import java.awt.Dimension;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.CountDownLatch;
import javax.imageio.ImageIO;
import org.sami.palette.Theme;
import org.sami.spn.testing.TemporaryFolder;

/**
 * Opens the {@link BusySituation} to be looked at, until the process is ended; with a folder as its first argument it makes pictures of the window in every
 * theme, at 100 and 150 %, small and large, and ends. With {@code --faults} five faults are there.
 */
final class BusySituationMain {
    private static final List<Dimension> SIZES = List.of(new Dimension(1600, 1000), new Dimension(1280, 800));
    private static final String FAULTS = "--faults"; // the last argument
    private static final int STANDARD_PERCENT = 100;
    private static final int LARGE_PERCENT = 150;

    private BusySituationMain() {}

    /** Opens it. */
    public static void main(String[] args) throws Exception {
        try (TemporaryFolder folder = new TemporaryFolder("crw-busy");
                BusySituation situation = new BusySituation(folder.path(), Theme.LIGHT, STANDARD_PERCENT)) {
            if (List.of(args).contains(FAULTS)) {
                situation.bringFaults();
            }
            if (args.length == 0 || args[0].equals(FAULTS)) {
                new CountDownLatch(1).await();
            }
            pictures(new WindowInMemory(situation.window()), Path.of(args[0]));
        }
        System.exit(0);
    }

    private static void pictures(WindowInMemory window, Path folder) throws IOException {
        Files.createDirectories(folder);
        for (Theme theme : Theme.values()) {
            for (int percent : List.of(STANDARD_PERCENT, LARGE_PERCENT)) {
                window.look(theme, percent);
                for (Dimension size : SIZES) {
                    window.size(size.width, size.height);
                    Path file = folder.resolve("busy-" + size.width + "-" + percent + "-" + theme.id() + ".png");
                    ImageIO.write(window.picture(), "png", file.toFile());
                    System.out.println(file);
                }
            }
        }
    }
}
