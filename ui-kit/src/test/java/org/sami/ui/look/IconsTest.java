package org.sami.ui.look;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;

import java.awt.Graphics2D;
import java.awt.image.BufferedImage;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import javax.swing.Icon;
import javax.swing.JLabel;
import org.junit.jupiter.api.Test;
import org.sami.palette.SemanticColor;

class IconsTest {
    @Test
    void eachIconIsDrawnInTheColourAskedFor() throws IOException {
        List<String> names;
        try (Stream<Path> files = Files.list(Path.of("src/main/resources/org/sami/ui/look/icons"))) {
            names = files.map(file -> file.getFileName().toString().replace(".svg", ""))
                    .toList();
        }

        assertThat(names).hasSizeGreaterThan(40).allSatisfy(name -> {
            Icon icon = Icons.of(name, 96, SemanticColor.CRITICAL);
            BufferedImage image =
                    new BufferedImage(icon.getIconWidth(), icon.getIconHeight(), BufferedImage.TYPE_INT_ARGB);
            Graphics2D g = image.createGraphics();
            icon.paintIcon(new JLabel(), g, 0, 0);
            g.dispose();
            assertThat(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                    .contains(SemanticColor.CRITICAL.in(Look.theme()).getRGB());
        });
    }

    @Test
    void refusesANameThatNoIconHas() {
        assertThatIllegalArgumentException()
                .isThrownBy(() -> Icons.small("bread"))
                .withMessageContaining("bread");
    }
}
