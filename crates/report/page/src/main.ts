// The page stands without this script: it makes curves and the model answer to the pointer.
import { enhanceCurves } from "./curves/curves";
import { showView } from "./view/view";

enhanceCurves();
showView();
