package org.sami.mavlink.onboard;

import io.dronefleet.mavlink.common.FileTransferProtocol;
import java.util.Optional;
import org.sami.mavlink.vehicle.VehicleId;

/** Answers requests for files: there are none. A station that tries to read the parameters as a file then reads them one by one at once, instead of after seconds without an answer. */
final class FileTransferAnswer {
    private static final int PAYLOAD = 251;
    private static final int HEAD = 12;
    private static final int SESSION = 2;
    private static final int OPCODE = 3;
    private static final int SIZE = 4;
    private static final int ASKED = 5;
    private static final int ENDS_SESSION = 1;
    private static final int ENDS_SESSIONS = 2;
    private static final byte ACK = (byte) 128;
    private static final byte NAK = (byte) 129;
    private static final byte NO_SUCH_FILE = 10;

    private FileTransferAnswer() {}

    /** The answer; empty to what is no request. */
    static Optional<Object> to(VehicleId station, FileTransferProtocol request) {
        byte[] asked = request.payload();
        if (asked.length < HEAD || asked[OPCODE] < 0) { // answers are 128 and more
            return Optional.empty();
        }
        byte[] answer = new byte[PAYLOAD];
        int next = ((asked[0] & 0xff) | ((asked[1] & 0xff) << 8)) + 1;
        answer[0] = (byte) next;
        answer[1] = (byte) (next >> 8);
        answer[SESSION] = asked[SESSION];
        answer[ASKED] = asked[OPCODE];
        boolean ends = asked[OPCODE] == ENDS_SESSION || asked[OPCODE] == ENDS_SESSIONS;
        answer[OPCODE] = ends ? ACK : NAK;
        if (!ends) {
            answer[SIZE] = 1;
            answer[HEAD] = NO_SUCH_FILE;
        }
        return Optional.of(FileTransferProtocol.builder()
                .targetSystem(station.system())
                .targetComponent(station.component())
                .payload(answer)
                .build());
    }
}
