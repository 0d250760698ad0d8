package org.sami.crw.sim.run.world;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.security.MessageDigest;
import java.security.NoSuchAlgorithmException;
import java.util.HexFormat;
import java.util.List;
import java.util.Optional;
import org.sami.boat.link.KeptFile;
import org.sami.crw.proxy.file.BoatFileFetch.NamedFiles;
import org.sami.crw.session.picture.PictureAccess;
import org.sami.crw.sim.picture.RecordingCamera;
import org.sami.crw.sim.picture.Scene;
import org.sami.crw.sim.picture.ScenePicture;

/** The pictures of a boat in simulated time, each drawn when it is fetched. */
record DrawnPictures(String boat, RecordingCamera camera) implements PictureAccess {
    @Override
    public void fetch(List<String> names, Path folder, NamedFiles result) throws IOException {
        for (String name : names) {
            Optional<Scene> scene = camera.scene(name);
            if (scene.isEmpty()) {
                result.missed(name, boat + " keeps no picture " + name + ", or does so no longer");
                continue;
            }
            byte[] picture = ScenePicture.jpeg(scene.get());
            KeptFile file = new KeptFile(name, KeptFile.PICTURE, picture.length, sha256(picture));
            Optional<String> whyNot = result.whyNot(file);
            if (whyNot.isPresent()) {
                result.missed(name, whyNot.get());
            } else {
                Path part = folder.resolve(name + ".part");
                Files.write(part, picture);
                result.come(file, Files.move(part, folder.resolve(name), StandardCopyOption.REPLACE_EXISTING));
            }
        }
    }

    private static String sha256(byte[] content) {
        try {
            return HexFormat.of().formatHex(MessageDigest.getInstance("SHA-256").digest(content));
        } catch (NoSuchAlgorithmException e) {
            throw new IllegalStateException("every Java has SHA-256", e);
        }
    }

    @Override
    public void cancel() {
        // nothing is waited for
    }
}
