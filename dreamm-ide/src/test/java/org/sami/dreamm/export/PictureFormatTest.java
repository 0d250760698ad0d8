package org.sami.dreamm.export;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.awt.image.BufferedImage;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import javax.imageio.ImageIO;
import org.apache.pdfbox.Loader;
import org.apache.pdfbox.pdmodel.PDDocument;
import org.apache.pdfbox.rendering.PDFRenderer;
import org.apache.pdfbox.text.PDFTextStripper;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;
import org.sami.picture.NetFonts;
import org.sami.picture.net.NetPicture;
import org.sami.spn.drawing.NetDetail;
import org.sami.spn.drawing.NetLayout;
import org.sami.spn.json.DomainLibrary;
import org.sami.spn.model.LayoutPoint;
import org.sami.spn.model.Note;
import org.sami.spn.model.Plan;

@Tag("long")
class PictureFormatTest {
    private static final DomainLibrary DOMAIN =
            DomainLibrary.fromClassPath("/org/sami/domain/crw").orThrow();
    private static final Plan PLAN = DOMAIN.combined()
            .plan("clv")
            .orElseThrow()
            .withNotes(List.of(new Note("Ask twice", Optional.of(new LayoutPoint(0, -200)))));
    private static final NetPicture PICTURE = new NetPicture(
            NetLayout.edited(PLAN, DOMAIN.vocabulary(), NetFonts::width, NetDetail.READER, OptionalDouble.empty()));

    @Test
    void aPdfIsOnePageOfThePicturesSizeWhoseTextCanBeSearched() throws IOException {
        try (PDDocument document = Loader.loadPDF(PictureFormat.PDF.write(PICTURE))) {
            assertThat(document.getNumberOfPages()).isEqualTo(1);
            assertThat((double) document.getPage(0).getMediaBox().getWidth())
                    .isCloseTo(PICTURE.bounds().getWidth(), within(1.0));
            assertThat(new PDFTextStripper().getText(document))
                    .contains("Choose allocation", "Ask twice", "Take All Relevant");
        }
    }

    @Test
    void aPdfLooksAsThePng() throws IOException {
        BufferedImage png = ImageIO.read(new ByteArrayInputStream(PictureFormat.PNG.write(PICTURE)));
        try (PDDocument document = Loader.loadPDF(PictureFormat.PDF.write(PICTURE))) {
            BufferedImage pdf = new PDFRenderer(document).renderImage(0, 2);

            assertThat(pdf.getWidth()).isCloseTo(png.getWidth(), within(2));
            assertThat(dark(pdf)).isCloseTo(dark(png), within(dark(png) / 5));
        }
    }

    private static long dark(BufferedImage image) {
        return Arrays.stream(image.getRGB(0, 0, image.getWidth(), image.getHeight(), null, 0, image.getWidth()))
                .filter(rgb -> (rgb & 0xFF) < 0x80)
                .count();
    }

    @Test
    void anSvgHasTheNotesToo() throws IOException {
        assertThat(new String(PictureFormat.SVG.write(PICTURE), StandardCharsets.UTF_8))
                .contains(">Ask twice<");
    }
}
