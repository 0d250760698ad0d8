package org.sami.ui.value;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import javax.imageio.ImageIO;
import javax.swing.JPanel;
import org.sami.palette.Theme;
import org.sami.ui.check.Layout;
import org.sami.ui.check.TextFit;
import org.sami.ui.look.Look;

/** Paints the gallery in every theme at 100 and 150 % into a folder, and says what does not fit. */
final class GalleryMain {
    private static final int WIDTH = 520;

    private GalleryMain() {}

    public static void main(String[] arguments) throws IOException {
        Path folder = Path.of(arguments[0]);
        Files.createDirectories(folder);
        for (Theme theme : Theme.values()) {
            for (int percent : new int[] {100, 150}) {
                Look.apply(theme, percent);
                JPanel sheet = Gallery.sheet();
                Layout.layOut(sheet, Look.px(WIDTH));
                Path file = folder.resolve(theme.id() + "-" + percent + ".png");
                ImageIO.write(Layout.paint(sheet), "png", file.toFile());
                System.out.println(file + " " + TextFit.faults(sheet));
            }
        }
    }
}
