package org.sami.boat.server.picture;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class PictureFolderTest {
    @TempDir
    Path folder;

    private List<String> files() throws IOException {
        try (Stream<Path> files = Files.list(folder)) {
            return files.map(file -> file.getFileName().toString()).sorted().toList();
        }
    }

    private static void keep(PictureFolder pictures, int bytes) throws IOException {
        pictures.keep(pictures.nextName(), new byte[bytes]);
    }

    @Test
    void oldestGoesWhereThereAreTooManyFiles() throws IOException {
        PictureFolder pictures = PictureFolder.open(folder, "anna", 2, 1000);
        for (int i = 0; i < 4; i++) {
            keep(pictures, 10);
        }

        assertThat(files()).containsExactly("anna-000003.jpg", "anna-000004.jpg");
    }

    @Test
    void oldestGoesWhereThereAreTooManyBytes() throws IOException {
        PictureFolder pictures = PictureFolder.open(folder, "anna", 100, 1000);
        keep(pictures, 400);
        keep(pictures, 400);
        keep(pictures, 500);

        assertThat(files()).containsExactly("anna-000002.jpg", "anna-000003.jpg");
    }

    @Test
    void numbersGoOnAfterARestartAndOtherFilesStay() throws IOException {
        keep(PictureFolder.open(folder, "anna", 9, 1000), 10);
        Files.writeString(folder.resolve("notes.txt"), "mine");

        PictureFolder again = PictureFolder.open(folder, "anna", 1, 1000);
        keep(again, 10);

        assertThat(files()).containsExactly("anna-000002.jpg", "notes.txt");
    }

    @Test
    void pictureThatIsTooLargeIsNamedAndDrivesOutNothing() throws IOException {
        PictureFolder pictures = PictureFolder.open(folder, "anna", 9, 1000);
        keep(pictures, 10);

        assertThatThrownBy(() -> keep(pictures, 1001))
                .isInstanceOf(IOException.class)
                .hasMessage("anna-000002.jpg has 1001 bytes, more than 1000: it is not kept");
        assertThat(files()).containsExactly("anna-000001.jpg");
    }
}
